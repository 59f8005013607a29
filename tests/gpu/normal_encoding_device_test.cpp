// CPU and GLSL compile shaders/shared/normal_encoding.h from the same text; here a device encodes into
// the real formats and decodes, and the CPU does the same.
#include "devices.hpp"
#include "directions.hpp"
#include "programs.hpp"
#include <cstring>
#include <shared/normal_encoding.h>

namespace prelight {
namespace {

constexpr uint32_t width = 1024, height = 512, count = width * height;

/// Directions over the sphere, the first ones on axes and on edges between octants; w: roughness.
std::vector<glm::vec4> make_directions() {
    std::vector<glm::vec4> all;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x || y || z)
                    all.emplace_back(glm::normalize(glm::vec3(x, y, z)), 0.5f);
    for (uint32_t i = static_cast<uint32_t>(all.size()); i < count; ++i)
        all.emplace_back(direction(i, count), 0.089 + (1 - 0.089) * i / count);
    return all;
}

uint32_t unorm(float value, uint32_t bits) {
    const float steps = static_cast<float>((1u << bits) - 1);
    return static_cast<uint32_t>(std::floor(value * steps + 0.5f));
}

/// The formats' bits, as they lie in memory.
uint32_t oct24_bits(glm::vec4 d) {
    const glm::vec3 e = shared::oct24_encode(d);
    return unorm(e.x, 8) | unorm(e.y, 8) << 8 | unorm(e.z, 8) << 16 |
           unorm(shared::roughness_encode(d.w), 8) << 24;
}
uint32_t oct32_bits(glm::vec4 d) {
    const glm::vec2 e = shared::oct32_encode(d);
    return unorm(e.x, 16) | unorm(e.y, 16) << 16;
}
uint32_t rgb10_bits(glm::vec4 d) {
    const glm::vec3 e = shared::rgb10_encode(d);
    return unorm(e.x, 10) | unorm(e.y, 10) << 10 | unorm(e.z, 10) << 20 | 3u << 30;
}

/// The two 12-bit numbers that oct24 spreads over three bytes, and the roughness.
glm::ivec3 oct24_numbers(uint32_t bits) {
    const uint32_t r = bits & 255, g = bits >> 8 & 255, b = bits >> 16 & 255;
    return {r << 4 | g >> 4, (g & 15) << 8 | b, bits >> 24};
}
glm::ivec3 oct32_numbers(uint32_t bits) { return {bits & 0xffff, bits >> 16, 0}; }
glm::ivec3 rgb10_numbers(uint32_t bits) { return {bits & 1023, bits >> 10 & 1023, bits >> 20 & 1023}; }

glm::vec3 oct24_decoded(uint32_t bits) {
    return shared::oct24_decode(glm::vec3(bits & 255, bits >> 8 & 255, bits >> 16 & 255) / 255.0f);
}
glm::vec3 oct32_decoded(uint32_t bits) {
    return shared::oct32_decode(glm::vec2(bits & 0xffff, bits >> 16) / 65535.0f);
}
glm::vec3 rgb10_decoded(uint32_t bits) {
    return shared::rgb10_decode(glm::vec3(rgb10_numbers(bits)) / 1023.0f);
}

struct Encoding {
    const char* name;
    uint32_t (*bits)(glm::vec4);
    glm::ivec3 (*numbers)(uint32_t);
    glm::vec3 (*decoded)(uint32_t);
    double mean, max;   ///< degrees, measured by NormalEncoding.*AngularError
    double may_differ;  ///< share of codes that may be one step away
};
// The octahedral encodings round to whole steps themselves; 10:10:10 leaves it to the target, and
// lavapipe stores floor(1024 u) instead of round(1023 u). That makes the stored normal longer by
// 1/1023, which the decoder's normalize() takes out again: the angles are held to the same bounds.
constexpr Encoding encodings[] = {
    {"oct24", oct24_bits, oct24_numbers, oct24_decoded, 0.0209, 0.0592, 0.0001},
    {"oct32", oct32_bits, oct32_numbers, oct32_decoded, 0.0013, 0.0037, 0.0001},
    {"rgb10", rgb10_bits, rgb10_numbers, rgb10_decoded, 0.0422, 0.0960, 0.65}};

class NormalEncodingOnDevice : public OnEachDevice {};

TEST_P(NormalEncodingOnDevice, AgreesWithTheCpu) {
    const std::vector<glm::vec4> directions = make_directions();
    const gpu::Buffer source(context(), "directions", count * sizeof(glm::vec4),
                             VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::BufferPlace::upload);
    std::copy(directions.begin(), directions.end(), source.mapped<glm::vec4>());
    const gpu::Buffer decoded(context(), "decoded", count * 3 * sizeof(glm::vec4),
                              VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::BufferPlace::readback);
    graph::FrameGraph graph(context());
    const std::array images{graph.image("oct24", {VK_FORMAT_R8G8B8A8_UNORM, {width, height}}),
                            graph.image("oct32", {VK_FORMAT_R16G16_UNORM, {width, height}}),
                            graph.image("rgb10", {VK_FORMAT_A2B10G10R10_UNORM_PACK32, {width, height}})};
    graph::Pass& encode = graph.pass("encode");
    encode.storage(0, graph.buffer("directions", source), false);
    graph::Pass& decode = graph.pass("decode");
    decode.storage(0, graph.buffer("decoded", decoded), true);
    for (uint32_t i = 0; i < images.size(); ++i) {
        encode.colour(images[i], graph::Load::discard);
        decode.sample(i + 1, images[i]);
        graph.keep(images[i]);
    }
    run_program(encode, context(), "encode_normals.frag", {width});
    run_program(decode, context(), "decode_normals.comp", {}, width / 8, height / 8);
    graph.compile();
    run_frame(context(), graph);

    for (uint32_t e = 0; e < 3; ++e) {
        SCOPED_TRACE(encodings[e].name);
        const std::vector<uint32_t> stored = texels<uint32_t>(graph, images[e]);
        int largest_step = 0;
        uint32_t differing = 0;
        Angles decoders, whole;
        for (uint32_t i = 0; i < count; ++i) {
            const glm::ivec3 step = glm::abs(encodings[e].numbers(stored[i]) -
                                             encodings[e].numbers(encodings[e].bits(directions[i])));
            largest_step = std::max({largest_step, step.x, step.y, step.z});
            differing += step != glm::ivec3(0);
            const glm::vec3 back(decoded.mapped<glm::vec4>()[3 * i + e]);
            decoders.add(angle(back, encodings[e].decoded(stored[i])));
            whole.add(angle(directions[i], back));
        }
        std::printf("    %s: %u of %u codes differ, by %d step at most; decoders apart by %.7f° at most\n",
                    encodings[e].name, differing, count, largest_step, decoders.max);
        EXPECT_LE(largest_step, 1);
        EXPECT_LE(differing, count * encodings[e].may_differ);
        EXPECT_LE(decoders.max, 3e-5); // some units in the last place of a float
        EXPECT_NEAR(whole.mean(), encodings[e].mean, encodings[e].mean * 0.01);
        EXPECT_LE(whole.max, encodings[e].max * 1.01);
    }
    const std::vector<uint32_t> stored = texels<uint32_t>(graph, images[0]);
    double roughness = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const double device = decoded.mapped<glm::vec4>()[3 * i].w;
        const float host = shared::roughness_decode(static_cast<float>(stored[i] >> 24) / 255.0f);
        roughness = std::max(roughness, std::abs(device / host - 1));
    }
    EXPECT_LE(roughness, 1e-5);
}
INSTANTIATE_TEST_SUITE_P(Drivers, NormalEncodingOnDevice,
                         testing::Values(Driver::lavapipe, Driver::swiftshader), driver_name);

} // namespace
} // namespace prelight
