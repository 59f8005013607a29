#pragma once
#include <gpu/buffer.hpp>
#include <gpu/descriptors.hpp>
#include <gpu/texture.hpp>
#include <map>
#include <optional>
#include <prelight/scene.hpp>
#include <resident/material_shaders.hpp>
#include <span>
#include <tuple>
#include <vector>

namespace prelight::resident {

/// One indexed draw of one object.
struct Draw {
    uint32_t first_index = 0;
    uint32_t index_count = 0;
    int32_t vertex_offset = 0;
    uint32_t object = 0; ///< index into World::instances
    uint32_t material = 0;
    uint32_t features = 0; ///< FEATURE_… bits of its material, and FEATURE_DECALS where decals reach it
    uint32_t shader = 0;   ///< of its material: index into Materials::shaders
    bool mirrored = false;
    bool double_sided = false;
    const Primitive* primitive = nullptr; ///< whose indices and vertices these are
    glm::dvec3 low{0}, high{0};           ///< a box around it, world space
    glm::vec3 largest{0};                 ///< |coordinate| of its vertices, object space
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
    std::vector<Draw> draws;

    /// The buffer for VERTEX_PREVIOUS_POSITION: `positions` where there is no other.
    VkBuffer previous() const { return previous_positions.handle() ? previous_positions.handle() : positions.handle(); }
};

/// The second vertex stream.
struct VertexAttributes {
    glm::vec3 normal;
    glm::vec4 tangent;
    glm::vec2 texcoord_0;
    glm::vec2 texcoord_1;
    uint16_t colour[4]; ///< unsigned normalised
};

/// What texels are: sRGB colours; linear values; a normal map, with normal_map_levels().
enum class TextureUse { colour, values, normals };

/// Textures, samplers and descriptor sets of materials.
struct Materials {
    explicit Materials(const gpu::Context& context) : pool(context) {}
    MaterialShaders shaders;
    gpu::MemoryPool pool;
    std::map<std::pair<const TextureImage*, TextureUse>, gpu::Texture> textures;
    std::map<std::tuple<const TextureImage*, float, uint32_t>, gpu::Texture> masks; ///< with mask_levels()
    std::vector<gpu::UniqueSampler> samplers;
    gpu::Buffer constants;
    gpu::Buffer parameters;                  ///< of the shaders; one block a material
    std::optional<gpu::Texture> environment; ///< MATERIAL_ENVIRONMENT
    std::optional<gpu::Texture> sky;         ///< MATERIAL_SKY
    std::optional<gpu::Texture> reflectance; ///< MATERIAL_REFLECTANCE
    gpu::UniqueSampler environment_sampler, table_sampler;
    gpu::Buffer environment_light; ///< EnvironmentConstants
    VkDescriptorSetLayout layout = VK_NULL_HANDLE;
    gpu::DescriptorSets sets; ///< by material index
    std::optional<gpu::DescriptorSets> isotropic_sets;
    /// For shaders that say themselves how large a footprint is (textureGrad): without anisotropic filtering on a
    /// software device, for lavapipe's takes its steps from neighbouring pixels whatever it is told.
    const gpu::DescriptorSets& sets_for_gradients() const { return isotropic_sets ? *isotropic_sets : sets; }
};

struct DecalBox;
/// FEATURE_… bits of a material.
uint32_t features_of(const Scene& scene, const Material& material);

/// `motion`: with previous positions; `trims`: the device reads positions and indices to trim them; `decals`: what may
/// reach objects.
Geometry upload_geometry(const gpu::Context& context, const World& world, bool motion, bool trims,
                         const MaterialShaders& shaders, std::span<const DecalBox> decals);
/// `exposure`: factor on emissive light. Throws Error naming an image that the device cannot hold.
Materials upload_materials(const gpu::Context& context, const Scene& scene, gpu::TextureFilter filter, double exposure);

} // namespace prelight::resident
