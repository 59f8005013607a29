#pragma once
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <prelight/scene.hpp>

namespace prelight::reference {

enum class Encoding { linear, srgb };

/// An sRGB code's linear value, 0 … 1 (IEC 61966-2-1).
double linear_of_srgb(uint8_t code);

/// Reads textures on level 0 in double precision; mip maps are not modelled. Texels sit at half
/// coordinates (glTF 2.0, 3.8.4), each axis wraps by itself, sRGB texels are decoded before they
/// are mixed; alpha is always linear.
class Textures {
public:
    /// `bilinear`: mix four texels whatever the sampler says; otherwise the sampler's magnification
    /// filter decides.
    Textures(const Scene& scene, bool bilinear) : scene_(scene), bilinear_(bilinear) {}

    /// RGBA 0 … 1. `uv` is the vertex attribute's value, before the texture's own transform.
    /// `ref` must refer to an image.
    glm::dvec4 sample(const TextureRef& ref, glm::dvec2 uv, Encoding encoding) const;

private:
    const Scene& scene_;
    bool bilinear_;
};

} // namespace prelight::reference
