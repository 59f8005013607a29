#pragma once
#include "device_trimming.hpp"
#include "gpu_scene.hpp"
#include "layer_decals.hpp"
#include "layer_slots.hpp"
#include "light_reach.hpp"
#include "light_set.hpp"
#include "shadow_plan.hpp"
#include "visible_draws.hpp"
#include "visible_pixels.hpp"
#include <gpu/frames_in_flight.hpp>
#include <gpu/raster.hpp>
#include <optional>
#include <prelight/renderer.hpp>

namespace prelight::resident {

struct ViewSettings {
    gpu::Raster raster;      ///< of the picture; with the samples of what surfaces are drawn into
    VkExtent2D frame{};      ///< whose shape the camera sees, where the raster is a rounded share of it; 0: the raster
    double exposure = 1;     ///< factor
    double light_scale = 32; ///< what stored light is divided by
    bool measures_light = false; ///< the device finds a light scale for each frame: passes::light_scale_passes()
    LightCulling culling = LightCulling::volumes;
    VolumeOptions volumes = {};
    ObjectLights object_lights = ObjectLights::none;
    DrawOptions draws = {};
    ShadowOptions shadows = {};
    bool layers = false;       ///< blended draws get slots: View::layers()
    bool layer_decals = false; ///< where decals lie on blended draws: View::layer_decals()
};

/// CPU time of one frame, milliseconds; as prelight::HostTimes names it.
struct UpdateTimes {
    double lights = 0, culling = 0, objects = 0;
    UpdateTimes& operator+=(const UpdateTimes& other) {
        lights += other.lights;
        culling += other.culling;
        objects += other.objects;
        return *this;
    }
};

/// A scene and its lights as one camera sees them: what of them may show, in which groups and with which shadow maps,
/// and set 0 of every pass. Alive as long as the frame graph that draws it, and not longer than scene and lights.
class View {
public:
    /// Throws Error when a buffer would be larger than the device allows; no light is ever dropped.
    View(const GpuScene& scene, const LightSet& lights, const ViewSettings& settings);
    /// Buffers with room for as many lights as `lights` holds, and its maps, before it takes the place of the set that
    /// the view refers to. No frame may be in flight. As before when it throws.
    void make_light_buffers(const LightSet& lights);
    /// Writes constants, lights and objects for one picture into the slot's buffers, which no frame in flight may use;
    /// set() is the slot's from then on.
    void update(const PlacedCamera& camera, uint32_t slot = 0);
    /// Of the last update().
    const UpdateTimes& update_times() const { return times_; }
    /// Whether update() finds the lights of blended draws, where it finds none of other objects.
    void find_blended_lights(bool finds) { finds_blended_lights_ = finds; }
    /// What it wrote for the device.
    uint64_t written_bytes() const { return written_; }

    const GpuScene& scene() const { return scene_; }
    const gpu::Context& context() const { return scene_.context(); }
    const LightSet& lights() const { return lights_; }
    /// Of the picture, one sample a pixel. What a pass writes has the raster of what it reads, where it reads a surface
    /// by pixel.
    gpu::Raster raster() const { return {settings_.raster.extent}; }
    /// Of what surfaces are drawn into.
    const gpu::Raster& surface_raster() const { return settings_.raster; }

    /// The lights that the camera of the last update() may see, by how they are drawn.
    const LightGroups& light_groups() const { return groups_; }
    /// Lights of each object; empty lists of those whose lights nobody wanted found.
    const LightReach& reach() const { return reach_; }
    /// What the camera of the last update() may see.
    const VisibleDraws& visible() const { return visible_; }
    /// Of its blended draws, with ViewSettings::layers.
    const LayerSlots& layers() const { return layers_; }
    /// Decals of blended draws; null: there are none, or no room for them.
    const LayerDecals* layer_decals() const { return layer_decals_ ? &*layer_decals_ : nullptr; }
    /// Shadow maps of the last update(); null without shadows.
    const ShadowPlan* shadows() const { return shadows_ ? &*shadows_ : nullptr; }
    /// The camera's position of the last update(), world space: the origin of what shaders call world.
    glm::dvec3 eye() const { return eye_; }
    /// World relative to eye() → clip space, of the last update().
    const glm::mat4& clip_from_world() const { return clip_from_world_; }

    const DrawOptions& draw_options() const { return settings_.draws; }
    LightCulling culling() const { return settings_.culling; }
    const VolumeOptions& volumes() const { return settings_.volumes; }
    double light_scale() const { return settings_.light_scale; }

    VkDescriptorSetLayout layout() const { return layout_; }
    VkDescriptorSet set() const { return sets_[slot_]; }
    /// ObjectData of the visible draws: a vertex buffer that steps once an instance.
    VkBuffer objects() const { return objects_[slot_].handle(); }
    VkBuffer commands() const { return slots_[slot_].commands.handle(); }
    VkBuffer trimmed_indices() const { return trimmed_[slot_].handle(); }
    /// FrameConstants; the device may write them too with ViewSettings::measures_light.
    const gpu::PerFrame<gpu::Buffer>& constant_buffers() const { return constants_; }
    /// Room for trim_casters() in the slot of the last update(): none where triangles are not trimmed on the host.
    const gpu::Buffer& caster_indices() const { return caster_indices_[slot_]; }
    const gpu::PerFrame<gpu::Buffer>& object_buffers() const { return objects_; }
    const gpu::PerFrame<gpu::Buffer>& trimmed_buffers() const { return trimmed_; }
    /// With DrawOptions::counts_pixels and trims_on_device(); else null.
    const VisiblePixels* visible_pixels() const { return visible_pixels_ ? &*visible_pixels_ : nullptr; }
    const DeviceTrimming* device_trimming() const { return device_trimming_ ? &*device_trimming_ : nullptr; }

    /// What the first pass over all geometry drew in the frame of the last update(), which must be done; and what
    /// later passes left out of it, where that is known.
    uint64_t triangles_drawn() const;
    std::optional<uint64_t> draws_skipped() const, triangles_skipped() const;

private:
    void make_draw_buffers();
    void update_shadows(const PlacedCamera& camera, shared::FrameConstants& constants);
    uint64_t write_lights();
    uint64_t write_records(shared::LightData* records);
    uint64_t write_positions(shared::LightData* records) const;
    VkExtent2D frame() const { return settings_.frame.width > 0 ? settings_.frame : settings_.raster.extent; }
    double aspect() const { return double(frame().width) / frame().height; }
    const GpuScene& scene_;
    const LightSet& lights_;
    ViewSettings settings_;
    bool finds_blended_lights_ = false;
    /// What the host writes for one frame.
    struct Slot {
        gpu::Buffer lights, order, bounds, shadows, distributions;
        gpu::UniqueBufferView light_texels, shadow_texels; ///< of `lights` and `shadows`
        gpu::Buffer commands;                              ///< what find_visible() writes
        struct {
            uint64_t lights = 0; ///< LightSet::version(); 0: nothing
            glm::dvec3 eye{0};
            std::vector<uint32_t> shadowed;
        } written; ///< what the records are of
    };
    gpu::PerFrame<Slot> slots_;
    gpu::PerFrame<gpu::Buffer> constants_;
    gpu::PerFrame<gpu::Buffer> objects_, trimmed_; ///< what find_visible() writes too
    gpu::PerFrame<gpu::Buffer> caster_indices_;
    std::optional<VisiblePixels> visible_pixels_;
    std::optional<DeviceTrimming> device_trimming_;
    uint32_t slot_ = 0; ///< of the last update()
    VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
    gpu::DescriptorSets sets_; ///< one a slot
    VisibleDraws visible_;
    LightGroups groups_;
    LightReach reach_;
    LayerSlots layers_;
    std::optional<LayerDecals> layer_decals_;
    std::optional<ShadowPlan> shadows_;
    gpu::UniqueSampler shadow_sampler_; ///< compares
    glm::dvec3 eye_{0};
    glm::mat4 clip_from_world_{1};
    UpdateTimes times_;
    uint64_t written_ = 0;
};

} // namespace prelight::resident
