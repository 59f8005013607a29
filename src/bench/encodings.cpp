#include "through_target.hpp"
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
    const bench::Stored through = bench::through_normal_target(context, encoding, directions);
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
            .bytes =
                graph::texel_bytes(through.format) + (holds_roughness ? 0 : graph::texel_bytes(VK_FORMAT_R16_SFLOAT)),
            .directions = static_cast<uint32_t>(angles.size()),
            .mean = sum / static_cast<double>(angles.size()),
            .percentile_99 = *percentile,
            .max = *std::max_element(percentile, angles.end())};
}

/// The light pre-pass with some settings, against the reference of its form.
class PictureError {
public:
    PictureError(Device& device, const World& world, const PlacedCamera& camera, const EncodingBench& options)
        : device_(device), world_(world), camera_(camera), options_(options),
          reference_(render_reference(world, camera, options.width, options.height, 0, {})),
          left_out_(reference_.left_out()) {}

    Comparison with(std::map<std::string, std::string> settings) const {
        settings["texture-filter"] = "bilinear";
        settings["specular-antialiasing"] = "off"; // roughness as the material says it, in the reference too
        const auto renderer = create_renderer(
            "light-prepass", &device_,
            {.width = options_.width, .height = options_.height, .settings = std::move(settings), .views = {"linear"}});
        renderer->set_world(world_);
        renderer->render(camera_);
        return compare(renderer->read("linear"), reference_.linear, left_out_);
    }

private:
    Device& device_;
    const World& world_;
    const PlacedCamera& camera_;
    const EncodingBench& options_;
    ReferencePicture reference_;
    std::vector<uint8_t> left_out_;
};

double largest_relative_error(const gpu::Context& context, const passes::DepthSourceInfo& source) {
    std::vector<glm::vec4> depths(64 * BENCH_WIDTH, glm::vec4(0));
    for (size_t i = 0; i < depths.size(); ++i)
        depths[i].x = static_cast<float>(0.1 * std::pow(1e5, double(i) / double(depths.size() - 1)));
    const bench::Stored through = bench::through_depth_target(context, source, depths);
    double largest = 0;
    for (size_t i = 0; i < depths.size(); ++i)
        largest = std::max(largest, std::abs(double(through.decoded[i].x) / depths[i].x - 1));
    return largest;
}

} // namespace

std::vector<EncodingFigures> bench_encodings(Device& device, const World& world, const PlacedCamera& camera,
                                             const EncodingBench& options) {
    const auto& context = dynamic_cast<const gpu::Context&>(device);
    const std::vector<glm::vec4> directions = bench::directions(options.directions);
    const PictureError picture(device, world, camera, options);
    std::vector<EncodingFigures> all;
    for (const passes::NormalEncodingInfo& encoding : passes::normal_encodings()) {
        EncodingFigures figures = angular_error(context, encoding, directions);
        figures.picture = picture.with({{"normals", encoding.name}});
        all.push_back(figures);
        if (options.done)
            options.done(figures);
    }
    return all;
}

std::vector<DepthFigures> bench_depth_sources(Device& device, const World& world, const PlacedCamera& camera,
                                              const EncodingBench& options) {
    const auto& context = dynamic_cast<const gpu::Context&>(device);
    const PictureError picture(device, world, camera, options);
    std::vector<DepthFigures> all;
    for (const passes::DepthSourceInfo& source : passes::depth_sources()) {
        DepthFigures figures{.name = source.name, .target = graph::format_name(source.format)};
        if (source.source != passes::DepthSource::attachment) {
            figures.bytes = graph::texel_bytes(source.format);
            figures.relative = largest_relative_error(context, source);
        }
        figures.picture = picture.with({{"depth", source.name}, {"normals", "oct32"}});
        all.push_back(figures);
    }
    return all;
}

} // namespace prelight
