#pragma once
#include "decals.hpp"
#include "deformation.hpp"
#include "scene.hpp"
#include "world_box.hpp"
#include <algorithm>
#include <array>
#include <gpu/buffer_updates.hpp>

namespace prelight::resident {

/// What of a world's data depends on how it is drawn.
struct GpuSceneSettings {
    gpu::TextureFilter texture_filter = gpu::TextureFilter::trilinear;
    double exposure = 1;      ///< factor on the light of emissive materials and of the environment
    bool motion = false;      ///< fill Geometry::previous_positions
    bool trimmed = false;     ///< the device reads positions and indices to trim them
    bool casters = false;     ///< fill caster_rows()
    bool surface_ids = false; ///< fill Geometry::groups
    bool blends = false;      ///< draws of materials with alphaMode BLEND are Draw::blended(); else they are opaque
    bool transmits = false;   ///< draws of materials that light comes through are Draw::transmissive(); else opaque
    bool operator==(const GpuSceneSettings&) const = default;
};

/// A world on the device: geometry, materials with their textures, environment. It knows no camera, no picture and no
/// lights; any number of views show it. The world stays alive as long, and what changes of it goes through update().
class GpuScene {
public:
    /// Throws Error when the world does not fit the device.
    GpuScene(const gpu::Context& context, const World& world, const GpuSceneSettings& settings);

    /// Takes in what has changed of the world, but for its lights; a view sees it from its next update() on, and
    /// updates() go into the next frame. False: it needs other draws or pipelines, that is, another GpuScene; then
    /// nothing has been taken in. Throws Error for numbers that are not there and values that may not be.
    bool update(const WorldChanges& changes);
    /// Skins and morph targets, which are at rest until passes::deformation_pass(); null: nothing that the device
    /// deforms.
    const DeviceDeformation* deformation() const { return deformation_ ? &*deformation_ : nullptr; }
    /// What the next frame copies before its passes.
    gpu::BufferUpdates& updates() { return updates_; }

    const gpu::Context& context() const { return context_; }
    const World& world() const { return world_; }
    const GpuSceneSettings& settings() const { return settings_; }
    /// Null: ambient light is the world's radiance.
    const Environment* environment() const { return world_.scene->environment.get(); }
    const Geometry& geometry() const { return geometry_; }
    const Materials& materials() const { return materials_; }
    /// Some draw is of that class, visible or not.
    bool has(DrawClass which) const { return has_[static_cast<size_t>(which)]; }
    bool blends() const { return has(DrawClass::blended); }
    /// Some blended draw fades before what is opaque (Material::softness).
    bool softens() const { return softens_; }
    bool transmits() const { return has(DrawClass::transmissive); }
    /// Something is drawn over the opaque picture.
    bool shows_through() const {
        return std::any_of(has_.begin() + 1, has_.end(), [](bool has) { return has; }); // the first is what is opaque
    }
    /// Of the world's decals, in the order in which they lie over each other.
    std::span<const DecalBox> decals() const { return decals_; }
    /// Around all that is drawn.
    const WorldBox& box() const { return box_; }
    /// Of every draw of the geometry: the rows of its matrix object → world relative to box()'s centre. A vertex
    /// buffer that steps once an instance, as casters of shadows are drawn: they do not move with the camera.
    VkBuffer caster_rows() const { return caster_rows_.handle(); }
    std::array<glm::vec4, 3> caster_row(const Draw& draw) const;

private:
    bool can_update(const WorldChanges& changes, std::span<const DecalBox> decals) const;
    bool fits(uint32_t instance, std::span<const DecalBox> decals) const;
    /// Instances that show one of them.
    std::vector<uint32_t> showing(std::span<const uint32_t> deformed) const;
    bool is_turned(const Instance& instance) const;
    /// Box and vertices of a draw of a deformed mesh, as it is now.
    void set_shape(Draw& draw) const;
    void update_vertices(uint32_t deformed);
    void update_boxes(std::span<const uint32_t> instances);
    void upload_casters();
    const gpu::Context& context_;
    const World& world_;
    GpuSceneSettings settings_;
    gpu::BufferUpdates updates_;
    Materials materials_;
    std::vector<DecalBox> decals_;
    Geometry geometry_;
    std::optional<DeviceDeformation> deformation_;
    WorldBox box_;
    std::array<bool, draw_classes> has_{};
    bool softens_ = false;
    gpu::Buffer caster_rows_;
    /// What instances show, as it was uploaded: mesh and deformed mesh.
    std::vector<std::pair<uint32_t, std::optional<uint32_t>>> shown_;
};

} // namespace prelight::resident
