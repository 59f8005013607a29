#pragma once
#include "gpu_scene.hpp"
#include <gpu/frames_in_flight.hpp>
#include <map>
#include <shared/layer_decals.h>

namespace prelight::resident {

/// Which decals lie on each blended object, and their textures: set 3 of what draws it. Of more than LAYER_DECALS_MOST
/// on one object the lowest are left out.
class LayerDecals {
public:
    /// Whether some blended draw has decals, and the device has room for their textures beside a material's.
    static bool wanted(const GpuScene& scene);
    static bool fits(const gpu::Context& context);

    explicit LayerDecals(const GpuScene& scene);
    /// Finds what reaches each object now, and writes it for the slot, which no frame in flight may use. `eye`: world
    /// space, the origin of what shaders call world.
    void update(const GpuScene& scene, const glm::dvec3& eye, uint32_t slot);

    VkDescriptorSetLayout layout() const { return layout_; }
    /// Of a draw, an index into Geometry::draws, in the slot of the last update().
    VkDescriptorSet set(uint32_t draw) const { return sets_[of_draw_.at(draw) + slot_ * of_draw_.size()]; }
    /// How many decals the last update() left out, on all objects.
    uint32_t left_out() const { return left_out_; }

private:
    using Numbers = std::vector<uint32_t>; ///< indices into GpuScene::decals(), lowest first
    std::vector<gpu::Binding> bindings(const GpuScene& scene, size_t set, const Numbers& decals) const;
    uint64_t stride_ = 0;                  ///< bytes from one list to the next
    std::map<uint32_t, uint32_t> of_draw_; ///< number of each draw that takes decals
    gpu::PerFrame<gpu::Buffer> lists_;
    VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
    gpu::DescriptorSets sets_;   ///< of each draw, slot after slot
    std::vector<Numbers> bound_; ///< whose textures each set holds
    uint32_t slot_ = 0, left_out_ = 0;
};

} // namespace prelight::resident
