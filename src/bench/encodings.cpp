#include "normal_error.hpp"
#include <algorithm>
#include <cmath>
#include <prelight/bench.hpp>
#include <prelight/reference.hpp>
#include <prelight/renderer.hpp>
#include <shared/normal_encoding.h>

namespace prelight {
namespace {

/// Degrees between two directions of any length; exact for small angles too.
double degrees_between(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 57.29577951308232;
}

EncodingFigures angular_error(const gpu::Context& context, const passes::NormalEncodingInfo& encoding,
                              const std::vector<glm::vec4>& directions) {
    const bench::EncodedNormals through = bench::through_target(context, encoding, directions);
    std::vector<double> angles(directions.size());
    double sum = 0;
    for (size_t i = 0; i < angles.size(); ++i)
        sum += angles[i] = degrees_between(glm::vec3(directions[i]), glm::vec3(through.decoded[i]));
    const auto percentile = angles.begin() + static_cast<std::ptrdiff_t>((angles.size() - 1) * 99 / 100);
    std::nth_element(angles.begin(), percentile, angles.end());
    const bool holds_roughness = shared::normal_holds_roughness(static_cast<int>(encoding.encoding));
    return {.name = encoding.name,
            .target = graph::format_name(through.format),
            .bits = encoding.bits,
            .bytes = graph::texel_bytes(through.format) +
                     (holds_roughness ? 0 : graph::texel_bytes(VK_FORMAT_R16_SFLOAT)),
            .directions = static_cast<uint32_t>(angles.size()),
            .mean = sum / static_cast<double>(angles.size()),
            .percentile_99 = *percentile,
            .max = *std::max_element(percentile, angles.end())};
}

} // namespace

std::vector<EncodingFigures> bench_encodings(Device& device, const World& world,
                                             const PlacedCamera& camera, const EncodingBench& options) {
    const auto& context = dynamic_cast<const gpu::Context&>(device);
    const std::vector<glm::vec4> directions = bench::directions(options.directions);
    const ReferencePicture reference = render_reference(world, camera, options.width, options.height, 0, {});
    const std::vector<uint8_t> left_out = reference.left_out();
    std::vector<EncodingFigures> all;
    for (const passes::NormalEncodingInfo& encoding : passes::normal_encodings()) {
        EncodingFigures figures = angular_error(context, encoding, directions);
        const auto renderer =
            create_renderer("light-prepass", &device,
                            {.width = options.width,
                             .height = options.height,
                             .settings = {{"normals", encoding.name}, {"texture-filter", "bilinear"}}});
        renderer->set_world(world);
        renderer->render(camera);
        figures.picture = compare(renderer->read("linear"), reference.linear, left_out);
        all.push_back(figures);
        if (options.done)
            options.done(figures);
    }
    return all;
}

} // namespace prelight
