#pragma once
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <prelight/scene.hpp>

namespace prelight::reference {

enum class Encoding { linear, srgb };

/// An sRGB code's linear value, 0 … 1 (IEC 61966-2-1).
double linear_of_srgb(uint8_t code);

/// How far texture coordinates, before the texture's own transform, run to the pixels beside one.
struct Footprint {
    glm::dvec2 across{0}, down{0};
};

/// Reads textures in double precision. Texels sit at half coordinates (glTF 2.0, 3.8.4), each axis
/// wraps by itself, sRGB texels are decoded before they are mixed; alpha is always linear.
class Textures {
public:
    /// `bilinear`: mix four texels of level 0 whatever the sampler says; otherwise its filters decide.
    Textures(const Scene& scene, bool bilinear);
    ~Textures();
    Textures(const Textures&) = delete;
    Textures& operator=(const Textures&) = delete;

    /// RGBA 0 … 1. `uv` is the vertex attribute's value, before the texture's own transform.
    /// `ref` must refer to an image. The larger side of the footprint, in texels, is 2^λ (Vulkan 1.3, 16.5.7): up to
    /// λ = 0 a texture is magnified, above it is minified, from level λ where it has mip maps. Texels of a
    /// level are the means of those they cover. No footprint: magnified.
    glm::dvec4 sample(const TextureRef& ref, glm::dvec2 uv, Encoding encoding, const Footprint& footprint = {}) const;

private:
    struct Level;
    struct Levels;
    const Levels& levels(uint32_t image, Encoding encoding) const;
    const Scene& scene_;
    bool bilinear_;
    std::unique_ptr<Levels[]> levels_; ///< two an image, made when one is first read
};

} // namespace prelight::reference
