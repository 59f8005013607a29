#include "read_back.hpp"
#include <glm/common.hpp>
#include <glm/gtc/packing.hpp>

namespace prelight {

static constexpr float half_max = 65504;

Image unpack(const std::byte* texels, VkFormat format, VkExtent2D extent) {
    Image image(extent.width, extent.height);
    if (format == VK_FORMAT_R8G8B8A8_UNORM || format == VK_FORMAT_R8G8B8A8_SRGB) { // the bytes as stored
        for (size_t i = 0; i < image.pixels.size(); ++i)
            for (int c = 0; c < 3; ++c)
                image.pixels[i][c] = static_cast<float>(texels[4 * i + size_t(c)]) / 255.0f;
        return image;
    }
    if (format == VK_FORMAT_R32G32B32A32_SFLOAT) {
        const auto* floats = reinterpret_cast<const float*>(texels);
        for (size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] =
                glm::clamp(glm::vec3(floats[4 * i], floats[4 * i + 1], floats[4 * i + 2]), -half_max, half_max);
        return image;
    }
    const auto* halves = reinterpret_cast<const uint16_t*>(texels);
    for (size_t i = 0; i < image.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            image.pixels[i][c] = glm::unpackHalf1x16(halves[4 * i + size_t(c)]);
    return image;
}

Texels hand_out(gpu::Buffer buffer, VkFormat format, VkExtent2D extent) {
    const auto kept = std::make_shared<const gpu::Buffer>(std::move(buffer));
    return {.width = extent.width,
            .height = extent.height,
            .format = format == VK_FORMAT_R32G32B32A32_SFLOAT   ? Texels::Format::rgba32f
                      : format == VK_FORMAT_R16G16B16A16_SFLOAT ? Texels::Format::rgba16f
                                                                : Texels::Format::rgba8,
            .bytes = {kept->mapped<std::byte>(), size_t(kept->size())},
            .memory = kept};
}

} // namespace prelight
