#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <prelight/error.hpp>
#include <prelight/views.hpp>
#include <reference/reference_views.hpp>

namespace prelight::reference {
namespace {

Image draw_depth(const Image& size, const std::vector<double>& depth) {
    Image image(size.width, size.height);
    // White at the camera, halved at each doubling of 1 + distance / 10 m, as the other renderers.
    for (size_t i = 0; i < depth.size(); ++i)
        if (std::isfinite(depth[i]))
            image.pixels[i] = glm::vec3(static_cast<float>(1 / (1 + depth[i] / 10)));
    return image;
}

Image draw_normals(const Image& size, const std::vector<double>& depth, const std::vector<glm::dvec3>& normals) {
    Image image(size.width, size.height);
    for (size_t i = 0; i < normals.size(); ++i)
        if (std::isfinite(depth[i]))
            image.pixels[i] = glm::vec3(normals[i]) * 0.5f + 0.5f;
    return image;
}

Image draw_sample(const SampleView& view, const ReferencePicture& picture, const ReferenceBuffers& buffers) {
    if (view.buffer == "depth")
        return draw_depth(picture.linear, buffers.samples.at(view.sample).depth);
    if (view.buffer == "normal") {
        const SampleSurfaces& seen = buffers.samples.at(view.sample);
        return draw_normals(picture.linear, seen.depth, seen.normal);
    }
    Image linear(picture.linear.width, picture.linear.height);
    for (size_t i = 0; i < linear.pixels.size(); ++i)
        linear.pixels[i] = picture.sample_colours[i * picture.samples + view.sample];
    return tonemap(linear, buffers.curve);
}

/// As a white diffuse surface would show it.
Image draw_light(Image light, double factor) {
    for (glm::vec3& pixel : light.pixels)
        pixel *= static_cast<float>(factor / 3.14159265358979323846);
    return tonemap(light, Tonemap::pbr_neutral);
}

Image draw_counts(const Image& size, const std::vector<uint32_t>& counts) {
    // Black, blue, cyan, green, yellow, red, white at 0, 1, 4, 16, 64, 256, 1,024.
    static constexpr std::array<glm::vec3, 7> ramp{
        {{0, 0, 0}, {0, 0, 1}, {0, 1, 1}, {0, 1, 0}, {1, 1, 0}, {1, 0, 0}, {1, 1, 1}}};
    Image image(size.width, size.height);
    for (size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] == 0)
            continue;
        const float place = std::min(1 + std::log2(static_cast<float>(counts[i])) / 2, 6.0f);
        const size_t step = std::min<size_t>(static_cast<size_t>(place), 5);
        image.pixels[i] = glm::mix(ramp[step], ramp[step + 1], place - static_cast<float>(step));
    }
    return image;
}

} // namespace

Image draw_view(std::string_view view, const ReferencePicture& picture, const ReferenceBuffers& buffers,
                double exposure_factor) {
    if (view == "depth")
        return draw_depth(picture.linear, picture.depth);
    if (view == "normal")
        return draw_normals(picture.linear, picture.depth, picture.normal);
    if (view == "albedo")
        return tonemap(buffers.albedo, Tonemap::none);
    if (view == "diffuse-light")
        return draw_light(buffers.diffuse_light, exposure_factor);
    if (view == "specular-light")
        return draw_light(buffers.specular_light, exposure_factor);
    if (view == "light-count")
        return draw_counts(picture.linear, buffers.light_count);
    if (view == "layers")
        return draw_counts(picture.linear, picture.layer_count);
    if (view == "ambient-occlusion")
        return buffers.visibility;
    if (const auto sample = sample_of_view(view))
        return draw_sample(*sample, picture, buffers);
    if (const auto number = layer_of_view(view))
        return tonemap(buffers.layers.at(*number), Tonemap::none);
    throw UsageError("reference: no view is named " + std::string(view));
}

} // namespace prelight::reference
