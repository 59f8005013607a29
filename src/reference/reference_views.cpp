#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <prelight/error.hpp>
#include <reference/reference_views.hpp>

namespace prelight::reference {
namespace {

Image draw_depth(const ReferencePicture& picture) {
    Image image(picture.linear.width, picture.linear.height);
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (const double depth : picture.depth)
        if (std::isfinite(depth)) {
            nearest = std::min(nearest, depth);
            farthest = std::max(farthest, depth);
        }
    const double range = std::max(farthest - nearest, 1e-9);
    for (size_t i = 0; i < picture.depth.size(); ++i)
        if (std::isfinite(picture.depth[i]))
            image.pixels[i] =
                glm::vec3(static_cast<float>(1 - 0.9 * (picture.depth[i] - nearest) / range));
    return image;
}

Image draw_normals(const ReferencePicture& picture) {
    Image image(picture.linear.width, picture.linear.height);
    for (size_t i = 0; i < picture.normal.size(); ++i)
        if (std::isfinite(picture.depth[i]))
            image.pixels[i] = glm::vec3(picture.normal[i]) * 0.5f + 0.5f;
    return image;
}

Image draw_light(Image light, double factor, Tonemap curve) {
    for (glm::vec3& pixel : light.pixels)
        pixel *= static_cast<float>(factor);
    return tonemap(light, curve);
}

Image draw_counts(const Image& size, const std::vector<uint32_t>& counts) {
    static constexpr std::array<glm::vec3, 5> ramp{
        {{0.1f, 0.2f, 0.9f}, {0, 0.6f, 0.7f}, {0.2f, 0.8f, 0.2f}, {1, 0.9f, 0.1f}, {0.9f, 0, 0}}};
    Image image(size.width, size.height);
    for (size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] == 0)
            continue;
        const float place = std::min(std::log2(static_cast<float>(counts[i])) / 6, 1.0f) * 4;
        const size_t step = std::min<size_t>(static_cast<size_t>(place), 3);
        image.pixels[i] = glm::mix(ramp[step], ramp[step + 1], place - static_cast<float>(step));
    }
    return image;
}

} // namespace

Image draw_view(std::string_view view, const ReferencePicture& picture,
                const ReferenceBuffers& buffers, double exposure_factor, Tonemap curve) {
    if (view == "depth")
        return draw_depth(picture);
    if (view == "normal")
        return draw_normals(picture);
    if (view == "albedo")
        return tonemap(buffers.albedo, Tonemap::none);
    if (view == "diffuse-light")
        return draw_light(buffers.diffuse_light, exposure_factor, curve);
    if (view == "specular-light")
        return draw_light(buffers.specular_light, exposure_factor, curve);
    if (view == "light-count")
        return draw_counts(picture.linear, buffers.light_count);
    throw UsageError("reference: no view is named " + std::string(view));
}

} // namespace prelight::reference
