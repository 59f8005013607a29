#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <prelight/scene.hpp>

namespace prelight {

// Ward's RGBE (Graphics Gems II, 1991): three mantissas of 8 bits and a shared exponent. As an RGBA picture an
// environment map fits into glTF's images.

using Rgbe = std::array<uint8_t, 4>;
Rgbe to_rgbe(glm::vec3 radiance); ///< what is negative or not finite becomes 0, what is too bright the brightest
glm::vec3 from_rgbe(Rgbe code);   ///< from_rgbe(to_rgbe(from_rgbe(c))) is from_rgbe(c)

TextureImage to_picture(const std::string& name, const Image& map);
Image from_picture(const TextureImage& picture);

} // namespace prelight
