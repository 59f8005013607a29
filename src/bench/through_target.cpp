#include "through_target.hpp"
#include <algorithm>
#include <cmath>
#include <gpu/buffer.hpp>
#include <prelight/error.hpp>

namespace prelight::bench {
namespace {

/// Gives `pass` a full-screen triangle that needs no frame.
void draw_everywhere(graph::Pass& pass, const gpu::Context& context, const char* fragment,
                     const gpu::Constants& constants) {
    auto pipeline = std::make_shared<gpu::GraphicsPipeline>();
    pass.prepare([=, &context](const graph::PassInterface& interface) {
        gpu::GraphicsPipelineDesc desc;
        desc.name = fragment;
        desc.vertex = "fullscreen.vert";
        desc.fragment = fragment;
        desc.constants = constants;
        desc.attachments = interface.attachments;
        desc.sets = {interface.inputs};
        *pipeline = gpu::GraphicsPipeline(context, desc);
    });
    pass.record([=](const graph::PassContext& pass_context) {
        pipeline->bind(pass_context.commands);
        pipeline->bind_set(pass_context.commands, SET_BENCH, pass_context.inputs);
        vkCmdDraw(pass_context.commands, 3, 1, 0, 0);
    });
}

Stored through_target(const gpu::Context& context, std::span<const VkFormat> formats, const gpu::Constants& constants,
                      std::span<const glm::vec4> values) {
    if (values.empty() || values.size() % BENCH_WIDTH)
        throw Error("bench: the number of values is no multiple of a row's");
    const gpu::Buffer source(context, "values", values.size_bytes(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                             gpu::BufferPlace::upload);
    std::copy(values.begin(), values.end(), source.mapped<glm::vec4>());
    const gpu::Raster raster{{BENCH_WIDTH, static_cast<uint32_t>(values.size() / BENCH_WIDTH)}};

    graph::FrameGraph graph(context);
    const graph::ImageId stored = graph.image("stored", raster, formats);
    const graph::ImageId decoded = graph.image("decoded", {VK_FORMAT_R32G32B32A32_SFLOAT, raster});
    graph::Pass& encode = graph.pass("encode");
    encode.colour(stored, graph::Load::discard).storage(BENCH_VALUES, graph.buffer("values", source), false);
    draw_everywhere(encode, context, "bench_encode.frag", constants);
    graph::Pass& decode = graph.pass("decode");
    decode.colour(decoded, graph::Load::discard).sample(BENCH_STORED, stored);
    draw_everywhere(decode, context, "bench_decode.frag", constants);
    graph.keep(stored);
    graph.keep(decoded);
    graph.compile();
    context.run("through a target", [&](VkCommandBuffer commands) { graph.record(commands); });

    Stored out{graph.desc(stored).format, graph.read_back(stored), {}};
    const std::vector<std::byte> bytes = graph.read_back(decoded);
    out.decoded.resize(values.size());
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<std::byte*>(out.decoded.data()));
    return out;
}

} // namespace

std::vector<glm::vec4> directions(uint32_t count) {
    count = (std::max(count, 1u) + BENCH_WIDTH - 1) / BENCH_WIDTH * BENCH_WIDTH;
    std::vector<glm::vec4> all;
    all.reserve(count);
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x || y || z)
                    all.emplace_back(glm::normalize(glm::dvec3(x, y, z)), 0.5f);
    for (uint32_t i = static_cast<uint32_t>(all.size()); i < count; ++i) {
        const double z = 1 - (2.0 * i + 1) / count, turn = 2.3999632297286533 * i;
        const double across = std::sqrt(1 - z * z);
        all.emplace_back(across * std::cos(turn), across * std::sin(turn), z, 0.089 + (1 - 0.089) * i / count);
    }
    return all;
}

Stored through_normal_target(const gpu::Context& context, const passes::NormalEncodingInfo& encoding,
                             std::span<const glm::vec4> directions) {
    return through_target(context, encoding.formats,
                          {{CONSTANT_NORMAL_ENCODING, static_cast<uint32_t>(encoding.encoding)}}, directions);
}

Stored through_depth_target(const gpu::Context& context, const passes::DepthSourceInfo& info,
                            std::span<const glm::vec4> depths) {
    return through_target(context, std::span(&info.format, 1),
                          {{CONSTANT_DEPTH_SOURCE, static_cast<uint32_t>(info.source)}}, depths);
}

} // namespace prelight::bench
