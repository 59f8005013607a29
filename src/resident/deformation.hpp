#pragma once
#include "scene.hpp"
#include <gpu/buffer_updates.hpp>
#include <shared/deformation.h>

namespace prelight::resident {

/// What the device makes the vertices of skins and morph targets from: meshes at rest, who moves them, and the shapes
/// that they have at the moment. passes::deformation_pass() writes them into the geometry's buffers.
class DeviceDeformation {
public:
    /// Of World::deformations that name a mesh; `geometry` has room for them. Throws Error when a buffer would be
    /// larger than the device allows.
    DeviceDeformation(const gpu::Context& context, const World& world, const Geometry& geometry);

    /// Whether its meshes could have been those of `world`, which may have other shapes.
    bool fits(const World& world, uint32_t deformed) const;
    /// The shape that World::deformations[deformed] has now.
    void update(const World& world, uint32_t deformed, gpu::BufferUpdates& updates);
    /// Another one after each update().
    uint64_t version() const { return version_; }

    /// Workgroups of deform.comp; each takes DEFORM_GROUP vertices of one primitive.
    uint32_t groups() const { return groups_; }
    const gpu::Buffer& jobs() const { return jobs_; }
    const gpu::Buffer& group_list() const { return group_list_; }
    const gpu::Buffer& base() const { return base_; }
    const gpu::Buffer& influences() const { return influences_; }
    const gpu::Buffer& targets() const { return targets_; }
    const gpu::Buffer& state() const { return state_; }

private:
    struct Place {
        uint64_t first = 0; ///< in the state, vec4
        std::optional<uint32_t> mesh;
        size_t joints = 0, weights = 0;
        size_t first_job = 0, jobs = 0;
    };
    std::vector<Place> places_;               ///< by index into World::deformed
    std::vector<shared::DeformJob> job_list_; ///< as jobs_ has them
    uint32_t groups_ = 0;
    gpu::Buffer jobs_, group_list_; ///< DeformJob; its number and the first vertex of each group
    gpu::Buffer base_, influences_, targets_, state_;
    uint64_t version_ = 1;
};

/// Whether the device makes the vertices of World::deformed[deformed].
inline bool deforms_on_device(const World& world, uint32_t deformed) {
    return deformed < world.deformations.size() && world.deformations[deformed].mesh.has_value();
}

/// The mesh whose vertices and triangles an instance is drawn with: for one that the device deforms, the mesh at rest.
inline const Mesh& drawn_mesh(const World& world, const Instance& instance) {
    return instance.deformed && deforms_on_device(world, *instance.deformed)
               ? world.scene->meshes[*world.deformations[*instance.deformed].mesh]
               : world.mesh_of(instance);
}

} // namespace prelight::resident
