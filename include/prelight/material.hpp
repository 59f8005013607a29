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

/// TextureRef::image of one that is not there.
inline constexpr uint32_t no_image = 0xffffffffu;

/// What texture coordinates outside of 0 … 1 show.
enum class Wrap : uint8_t {
    repeat,          ///< the picture again
    mirrored_repeat, ///< the picture again, every other time mirrored
    clamp_to_edge,   ///< its edge
};
/// How texels of a level become a colour.
enum class Filter : uint8_t {
    nearest, ///< the nearest one
    linear,  ///< the four around, by their distance
};
/// How mip levels do.
enum class MipFilter : uint8_t {
    none,    ///< the picture itself alone
    nearest, ///< the level that fits best
    linear,  ///< the two that fit best, by how well they do
};

/// How a texture is read, as glTF's samplers say it.
struct Sampler {
    Wrap wrap_s = Wrap::repeat;        ///< across
    Wrap wrap_t = Wrap::repeat;        ///< down
    Filter mag = Filter::linear;       ///< where a texel covers more than a pixel
    Filter min = Filter::linear;       ///< where it covers less
    MipFilter mip = MipFilter::linear; ///< where it covers less
    /// Member by member.
    bool operator==(const Sampler&) const = default;
};

/// A use of an image by a material.
struct TextureRef {
    uint32_t image = no_image; ///< index into Scene::images, or no_image
    Sampler sampler;           ///< how it is read
    uint32_t texcoord = 0;     ///< texture-coordinate set, 0 or 1
    glm::mat2 uv_linear{1};    ///< KHR_texture_transform: uv' = uv_linear · uv + uv_offset
    glm::vec2 uv_offset{0};    ///< see uv_linear
    /// Whether there is one.
    explicit operator bool() const { return image != no_image; }
};

struct MaterialShader; // material_shader.hpp

/// What a material's alpha does.
enum class AlphaMode {
    opaque, ///< nothing
    mask,   ///< below Material::alpha_cutoff the surface is not there
    blend,  ///< it lets through 1 − alpha of what is behind it
};

/// glTF 2.0 metallic-roughness material. Texture channels are glTF's; base colour and emissive
/// images are sRGB-encoded, the others linear.
struct Material {
    std::string name;                         ///< of the file; may be empty
    glm::vec4 base_colour{1};                 ///< linear RGBA factor
    float metallic = 1;                       ///< 0 … 1
    float roughness = 1;                      ///< perceptual, 0 … 1; shading uses max(roughness, 0.089)
    glm::vec3 emissive{0};                    ///< linear, factor × KHR_materials_emissive_strength
    float normal_scale = 1;                   ///< factor on X and Y of the normal texture's vectors
    float occlusion_strength = 1;             ///< 0 … 1, on ambient light only
    AlphaMode alpha_mode = AlphaMode::opaque; ///< what the base colour's alpha does
    float alpha_cutoff = 0.5f;                ///< mask: a surface with alpha < cutoff is not there
    /// Metres ≥ 0. A blended surface loses its alpha, α · min(d / softness, 1), as the opaque surface behind it comes
    /// nearer; d is their distance along the camera's axis. 0: it ends where it meets others, in a sharp line.
    float softness = 0;
    bool double_sided = false;             ///< backs are drawn too, with their normals turned
    bool unlit = false;                    ///< KHR_materials_unlit: colour = base colour, no light
    bool receives_decals = true;           ///< decals (decal.hpp) lie on it
    TextureRef base_colour_texture;        ///< RGB and alpha, factors on base_colour
    TextureRef metallic_roughness_texture; ///< G roughness, B metallic
    TextureRef normal_texture;             ///< tangent space, +Y up
    TextureRef occlusion_texture;          ///< R
    TextureRef emissive_texture;           ///< RGB, a factor on emissive

    /// How it is shaded: material_shader.hpp. Null: the renderer's own way, metallic-roughness in
    /// Shading::ggx, Blinn-Phong in Shading::phong.
    std::shared_ptr<const MaterialShader> shader{};
    std::map<std::string, glm::vec4> parameters{}; ///< of the shader, by name; what is absent has its default
    std::map<std::string, TextureRef> textures{};  ///< of the shader, by name
};

} // namespace prelight
