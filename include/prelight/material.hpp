#pragma once
#include <cstdint>
#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <memory>
#include <prelight/glm_defaults.hpp>
#include <string>

namespace prelight {

inline constexpr uint32_t no_image = 0xffffffffu;

enum class Wrap : uint8_t { repeat, mirrored_repeat, clamp_to_edge };
enum class Filter : uint8_t { nearest, linear };
enum class MipFilter : uint8_t { none, nearest, linear };

struct Sampler {
    Wrap wrap_s = Wrap::repeat;
    Wrap wrap_t = Wrap::repeat;
    Filter mag = Filter::linear;
    Filter min = Filter::linear;
    MipFilter mip = MipFilter::linear;
    bool operator==(const Sampler&) const = default;
};

/// A use of an image by a material.
struct TextureRef {
    uint32_t image = no_image; ///< index into Scene::images, or no_image
    Sampler sampler;
    uint32_t texcoord = 0;  ///< texture-coordinate set, 0 or 1
    glm::mat2 uv_linear{1}; ///< KHR_texture_transform: uv' = uv_linear · uv + uv_offset
    glm::vec2 uv_offset{0};
    explicit operator bool() const { return image != no_image; }
};

struct MaterialShader; // material_shader.hpp

enum class AlphaMode { opaque, mask, blend };

/// glTF 2.0 metallic-roughness material. Texture channels are glTF's; base colour and emissive
/// images are sRGB-encoded, the others linear.
struct Material {
    std::string name;
    glm::vec4 base_colour{1}; ///< linear RGBA factor
    float metallic = 1;       ///< 0 … 1
    float roughness = 1;      ///< perceptual, 0 … 1; shading uses max(roughness, 0.089)
    glm::vec3 emissive{0};    ///< linear, factor × KHR_materials_emissive_strength
    float normal_scale = 1;
    float occlusion_strength = 1; ///< 0 … 1, on ambient light only
    AlphaMode alpha_mode = AlphaMode::opaque;
    float alpha_cutoff = 0.5f; ///< mask: a surface with alpha < cutoff is not there
    /// Metres ≥ 0. A blended surface loses its alpha, α · min(d / softness, 1), as the opaque surface behind it comes
    /// nearer; d is their distance along the camera's axis. 0: it ends where it meets others, in a sharp line.
    float softness = 0;
    bool double_sided = false;
    bool unlit = false;          ///< KHR_materials_unlit: colour = base colour, no light
    bool receives_decals = true; ///< decals (decal.hpp) lie on it
    TextureRef base_colour_texture;
    TextureRef metallic_roughness_texture; ///< G roughness, B metallic
    TextureRef normal_texture;             ///< tangent space, +Y up
    TextureRef occlusion_texture;          ///< R
    TextureRef emissive_texture;

    /// How it is shaded: material_shader.hpp. Null: the renderer's own way, metallic-roughness in
    /// Shading::ggx, Blinn-Phong in Shading::phong.
    std::shared_ptr<const MaterialShader> shader{};
    std::map<std::string, glm::vec4> parameters{}; ///< of the shader, by name; what is absent has its default
    std::map<std::string, TextureRef> textures{};  ///< of the shader, by name
};

} // namespace prelight
