#pragma once
#include <array>
#include <glm/common.hpp>
#include <gpu/buffer.hpp>
#include <gpu/buffer_updates.hpp>
#include <gpu/descriptors.hpp>
#include <gpu/texture.hpp>
#include <map>
#include <optional>
#include <prelight/scene.hpp>
#include <resident/material_shaders.hpp>
#include <shared/bindings.h>
#include <shared/frame.h>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace prelight::resident {

/// When an object is drawn: one class after the other.
enum class DrawClass : uint8_t {
    opaque,
    transmissive, ///< what is opaque behind it shows through it
    blended,      ///< over what is behind it
};
inline constexpr size_t draw_classes = 3;

/// One indexed draw of one object.
struct Draw {
    uint32_t first_index = 0;
    uint32_t index_count = 0;
    int32_t vertex_offset = 0;
    uint32_t object = 0; ///< index into World::instances
    uint32_t material = 0;
    /// FEATURE_… bits of its material, and those of its own: DECALS, BLENDED, SOFT, TRANSMISSIVE, FACING.
    uint32_t features = 0;
    uint32_t shader = 0; ///< of its material: index into Materials::shaders
    bool mirrored = false;
    bool double_sided = false;
    uint32_t part = 0;                    ///< index into Mesh::primitives
    const Primitive* primitive = nullptr; ///< whose indices and vertices these are; null: the device makes the vertices
    glm::vec3 own_low{0}, own_high{0};    ///< a box around its vertices' positions, object space
    float facing_reach = 0;               ///< metres that vertices stand from those positions at most
    glm::dvec3 low{0}, high{0};           ///< a box around its vertices, world space
    std::array<glm::vec4, 3> normal_row{}; ///< of the object's record
    bool visible = true;
    uint32_t version = 0; ///< another one after each change of what the draw shows

    DrawClass draw_class() const {
        return (features & FEATURE_TRANSMISSIVE) != 0 ? DrawClass::transmissive
               : (features & FEATURE_BLENDED) != 0    ? DrawClass::blended
                                                      : DrawClass::opaque;
    }
    bool blended() const { return draw_class() == DrawClass::blended; }
    bool transmissive() const { return draw_class() == DrawClass::transmissive; }
    /// Its vertices stand in the viewer's plane (Primitive::facing), whichever way the object is turned.
    bool facing() const { return (features & FEATURE_FACING) != 0; }
    /// After a change of `own_low` and `own_high`, or of the object's transform.
    void bound(const glm::dmat4& transform);
    /// All that follows from where the object is: also its record, and whether it shows.
    void place(const Instance& instance);
    /// |coordinate| of its vertices, object space.
    glm::vec3 largest() const { return glm::max(glm::abs(own_low), glm::abs(own_high)); }
};

/// Where a primitive's vertices lie, and what of it must stay for others to take their place.
struct VertexRange {
    uint32_t first = 0; ///< in positions, previous positions and attributes
    uint32_t vertices = 0;
    std::vector<uint32_t> first_triangle; ///< a skin may turn all of them round
    size_t indices = 0;
    bool fits(const Primitive& primitive) const;
};

/// All vertices of a world in device buffers, and the draws that show it, sorted so that
/// pipeline and material change least.
struct Geometry {
    gpu::Buffer positions;  ///< vec3, object space
    gpu::Buffer attributes; ///< VertexAttributes
    gpu::Buffer indices;    ///< uint32
    /// vec3, object space one interval earlier, vertex for vertex as `positions`. Made only when asked
    /// for and some vertex has moved within its object.
    gpu::Buffer previous_positions;
    /// uint32 a vertex: smooth_groups() of its primitive. Made only when asked for.
    gpu::Buffer groups;
    std::vector<Draw> draws;
    std::vector<std::vector<uint32_t>> draws_of; ///< by index into World::instances: numbers of its draws
    /// By index into World::deformed, then by primitive; empty for what no instance shows.
    std::vector<std::vector<VertexRange>> deformed;

    /// The buffer for VERTEX_PREVIOUS_POSITION: `positions` where there is no other.
    VkBuffer previous() const { return previous_positions.handle() ? previous_positions.handle() : positions.handle(); }
};

/// The second vertex stream.
struct VertexAttributes {
    glm::vec3 normal{0};
    glm::vec4 tangent{0};
    glm::vec2 texcoord_0{0};
    glm::vec2 texcoord_1{0};
    uint16_t colour[4]; ///< unsigned normalised
};

/// What texels are: sRGB colours; linear values; a normal map, with normal_map_levels().
enum class TextureUse { colour, values, normals };

/// All of a material that draws, pipelines and descriptor sets were made for: while it stays, only constants change.
struct MaterialKey {
    const MaterialShader* shader = nullptr;
    AlphaMode alpha_mode = AlphaMode::opaque;
    bool unlit = false, double_sided = false, receives_decals = true, transmits = false, soft = false;
    float mask_cutoff = 0;                              ///< that the levels of its texture were made for
    std::vector<std::pair<uint32_t, Sampler>> textures; ///< image and sampler of each slot
    bool operator==(const MaterialKey&) const = default;
};
/// Of every material of the scene.
std::vector<MaterialKey> material_keys(const Scene& scene);

/// Textures, samplers and descriptor sets of materials.
struct Materials {
    explicit Materials(const gpu::Context& context) : pool(context) {}
    MaterialShaders shaders;
    gpu::MemoryPool pool;
    std::map<std::pair<const TextureImage*, TextureUse>, gpu::Texture> textures;
    std::map<std::tuple<const TextureImage*, float, uint32_t>, gpu::Texture> masks; ///< with mask_levels()
    std::vector<gpu::UniqueSampler> samplers;
    gpu::Buffer constants;                                ///< one block a material
    gpu::Buffer parameters;                               ///< of the shaders; one block a material
    uint64_t constants_stride = 0, parameters_stride = 0; ///< bytes from one block to the next
    std::vector<MaterialKey> keys;                        ///< by material index
    std::optional<gpu::Texture> environment;              ///< MATERIAL_ENVIRONMENT
    std::optional<gpu::Texture> sky;                      ///< MATERIAL_SKY
    std::optional<gpu::Texture> reflectance;              ///< MATERIAL_REFLECTANCE
    gpu::UniqueSampler environment_sampler, table_sampler;
    gpu::Buffer environment_light; ///< EnvironmentConstants
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    gpu::DescriptorSets sets; ///< by material index
    /// Likewise: textures of base colour, metallic-roughness and normals as they are bound there.
    std::vector<std::array<gpu::Binding, 3>> surface_maps;
    std::optional<gpu::DescriptorSets> isotropic_sets;
    /// For shaders that say themselves how large a footprint is (textureGrad): without anisotropic filtering on a
    /// software device, for lavapipe's takes its steps from neighbouring pixels whatever it is told.
    const gpu::DescriptorSets& sets_for_gradients() const { return isotropic_sets ? *isotropic_sets : sets; }
};

/// The second stream of a primitive.
std::vector<VertexAttributes> attributes_of(const Primitive& primitive);
/// Least and largest coordinates; of no points, an empty box.
std::pair<glm::vec3, glm::vec3> box_of(std::span<const glm::vec3> points);

struct DecalBox;
/// FEATURE_… bits of a material.
uint32_t features_of(const Scene& scene, const Material& material);

/// `exposure`: factor on emissive light.
shared::MaterialConstants material_constants(const Material& material, double exposure);

struct GpuSceneSettings;
/// `decals`: what may reach objects.
Geometry upload_geometry(const gpu::Context& context, const World& world, const GpuSceneSettings& settings,
                         const MaterialShaders& shaders, std::span<const DecalBox> decals);
/// Writes the material's constants and parameters. Throws Error for values that it may not have.
void update_material(const Materials& materials, const Scene& scene, uint32_t material, double exposure,
                     gpu::BufferUpdates& updates);
/// `exposure`: factor on emissive light. Throws Error naming an image that the device cannot hold.
Materials upload_materials(const gpu::Context& context, const Scene& scene, gpu::TextureFilter filter, double exposure);

} // namespace prelight::resident
