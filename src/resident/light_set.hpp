#pragma once
#include "distribution_maps.hpp"
#include "gpu_scene.hpp"
#include "lights.hpp"
#include <memory>
#include <optional>

namespace prelight::resident {

/// The lights of a world as they are now, with cookies and profiles on the device. Where a view sees them is the
/// view's: its records are relative to its camera.
class LightSet {
public:
    /// The world's own lights. Throws Error as check_lights() does, and when maps do not fit the device.
    explicit LightSet(const GpuScene& scene);
    /// Others in their place: with maps for them, and with room for some more than there are, so that adding one at a
    /// time is cheap. For checked lights that the set does not hold(). Throws Error when they do not fit the device;
    /// the set stays as it is.
    LightSet with(std::span<const PlacedLight> lights) const;

    /// Whether replace() can take them.
    bool holds(std::span<const PlacedLight> lights) const;
    /// Takes checked lights in place of those there are.
    void replace(std::span<const PlacedLight> lights);

    /// By the index that shaders know them by.
    std::span<const PlacedLight> placed() const { return placed_; }
    const LightSpheres& spheres() const { return spheres_; }
    /// Another one, and never 0, whenever the lights are others.
    uint64_t version() const { return version_; }
    /// LIGHT_KIND_… bits of the lights there are: shaders leave out what only the others need.
    uint32_t kinds() const { return kinds_; }
    /// How many lights a view's buffers have room for.
    size_t capacity() const { return capacity_; }

    /// Null: no light throws a picture or has a profile.
    const gpu::Texture* distribution_picture() const { return uploaded_ ? &*uploaded_->picture : nullptr; }
    VkSampler distribution_sampler() const { return uploaded_->sampler; }
    VkBuffer distribution_levels() const { return uploaded_->levels.handle(); }
    /// Of a light that has a distribution.
    shared::DistributionData distribution(const PlacedLight& light) const { return maps_->record(light); }

private:
    LightSet(const GpuScene& scene, std::span<const PlacedLight> lights, size_t capacity);
    bool has_maps_of(std::span<const PlacedLight> lights) const;
    void upload_maps();

    const GpuScene* scene_;
    std::vector<PlacedLight> placed_;
    LightSpheres spheres_; ///< of `placed_`
    uint64_t version_ = 1;
    uint32_t kinds_ = 0; ///< found when lights come: every frame may bring 65,536
    size_t capacity_ = 0;
    /// Of the lights and of the scene's, which may come in later. Sets with the same maps share them.
    std::shared_ptr<const DistributionMaps> maps_;
    struct UploadedMaps {
        explicit UploadedMaps(const gpu::Context& context) : pool(context) {}
        gpu::MemoryPool pool;
        std::optional<gpu::Texture> picture;
        gpu::Buffer levels;
        gpu::UniqueSampler sampler;
    };
    std::shared_ptr<const UploadedMaps> uploaded_;
};

} // namespace prelight::resident
