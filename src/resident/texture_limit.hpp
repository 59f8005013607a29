#pragma once
#include <optional>
#include <prelight/scene.hpp>
#include <scene/images/scaled_picture.hpp>
#include <string>
#include <vector>

namespace prelight::resident {

/// The image scaled down to at most `limit` texels a side; nothing where it is no larger.
std::optional<TextureImage> scaled_to_limit(const TextureImage& image, images::Texels kind, uint32_t limit);

/// A line for each of the scene's images that scaled_to_limit() makes smaller. Of those alone that materials use.
std::vector<std::string> notes_on_large_textures(const Scene& scene, uint32_t limit);

} // namespace prelight::resident
