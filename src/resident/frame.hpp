#pragma once
#include "decals.hpp"
#include "device_trimming.hpp"
#include "distribution_maps.hpp"
#include "light_reach.hpp"
#include "lights.hpp"
#include "scene.hpp"
#include "shadow_plan.hpp"
#include "visible_draws.hpp"
#include "visible_pixels.hpp"
#include <functional>
#include <gpu/frames_in_flight.hpp>
#include <optional>
#include <prelight/renderer.hpp>

namespace prelight::resident {

struct FrameSettings {
    uint32_t width = 0, height = 0;
    double exposure = 1;         ///< factor
    double light_scale = 32;     ///< what stored light is divided by
    bool measures_light = false; ///< the device finds a light scale for each frame: passes::light_scale_passes()
    LightCulling culling = LightCulling::volumes;
    VolumeOptions volumes = {};
    ObjectLights object_lights = ObjectLights::none;
    gpu::TextureFilter texture_filter = gpu::TextureFilter::trilinear;
    bool motion = false; ///< fill Geometry::previous_positions
    DrawOptions draws = {};
    ShadowOptions shadows = {};
};

/// CPU time of the calling thread for one frame, milliseconds; as prelight::HostTimes names it.
struct UpdateTimes {
    double lights = 0, culling = 0, objects = 0;
};

/// A world on the device: what set 0 of every pass holds, geometry, materials, and this frame's
/// lights. Alive as long as the frame graph that draws it.
class Frame {
public:
    /// Throws Error when the world does not fit the device; no light is ever dropped.
    Frame(const gpu::Context& context, const World& world, const FrameSettings& settings);
    /// Takes other lights in place of the world's. False when what draws them must be built anew: their
    /// buffers grew, or a kind or falloff came in that shaders leave out. `wait` is called before buffers or maps are
    /// made anew, and comes back when the device is idle; without it, it is. Throws Error as check_lights() does.
    bool set_lights(std::span<const PlacedLight> lights, const std::function<void()>& wait = {});
    /// Writes constants, lights and objects for one picture into the slot's buffers, which no frame on
    /// its way may use; set() is the slot's from then on.
    void update(const PlacedCamera& camera, uint32_t slot = 0);

    /// Of the last update(), and of the calls of set_lights() before it.
    const UpdateTimes& update_times() const { return times_; }

    const gpu::Context& context() const { return context_; }
    const World& world() const { return world_; }
    /// Null: ambient light is the world's radiance.
    const Environment* environment() const { return world_.scene->environment.get(); }
    const Geometry& geometry() const { return geometry_; }
    const Materials& materials() const { return materials_; }
    /// Of the world's decals, in the order in which they lie over each other.
    std::span<const DecalBox> decals() const { return decals_; }
    /// All lights, by the index that shaders know them by.
    std::span<const PlacedLight> placed_lights() const { return placed_; }
    const LightGroups& lights() const { return groups_; }
    /// Lights of each object; empty lists with ObjectLights::none.
    const LightReach& reach() const { return reach_; }
    /// What the camera of the last update() may see.
    const VisibleDraws& visible() const { return visible_; }
    /// Shadow maps of the last update(); null without shadows.
    const ShadowPlan* shadows() const { return shadows_ ? &*shadows_ : nullptr; }
    /// Of every draw of the geometry: the rows of its matrix object → world relative to the world's centre. A vertex
    /// buffer that steps once an instance, as casters of shadows are drawn: they do not move with the camera.
    VkBuffer caster_rows() const { return caster_rows_.handle(); }
    const DrawOptions& draw_options() const { return settings_.draws; }
    /// ObjectData of the visible draws: a vertex buffer that steps once an instance.
    VkBuffer objects() const { return objects_[slot_].handle(); }
    VkBuffer commands() const { return slots_[slot_].commands.handle(); }
    VkBuffer trimmed_indices() const { return trimmed_[slot_].handle(); }
    /// FrameConstants; the device may write them too with FrameSettings::measures_light.
    const gpu::PerFrame<gpu::Buffer>& constant_buffers() const { return constants_; }
    const gpu::PerFrame<gpu::Buffer>& object_buffers() const { return objects_; }
    const gpu::PerFrame<gpu::Buffer>& trimmed_buffers() const { return trimmed_; }
    /// With DrawOptions::counts_pixels and trims_on_device(); else null.
    const VisiblePixels* visible_pixels() const { return visible_pixels_ ? &*visible_pixels_ : nullptr; }
    const DeviceTrimming* device_trimming() const { return device_trimming_ ? &*device_trimming_ : nullptr; }
    /// What the first pass over all geometry drew in the frame of the last update(), which must be done; and what
    /// later passes left out of it, where that is known.
    uint64_t triangles_drawn() const;
    std::optional<uint64_t> draws_skipped() const, triangles_skipped() const;
    /// The camera's position of the last update(), world space: the origin of what shaders call world.
    glm::dvec3 eye() const { return eye_; }
    /// World relative to eye() → clip space, of the last update().
    const glm::mat4& clip_from_world() const { return clip_from_world_; }
    /// FrameSettings::light_scale
    double light_scale() const { return settings_.light_scale; }
    LightCulling culling() const { return settings_.culling; }
    const VolumeOptions& volumes() const { return settings_.volumes; }
    VkExtent2D extent() const { return {settings_.width, settings_.height}; }
    VkDescriptorSetLayout layout() const { return layout_; }
    VkDescriptorSet set() const { return sets_[slot_]; }
    /// The most lights that set_lights() takes without anything being built anew.
    size_t light_capacity() const { return capacity_; }
    /// LIGHT_KIND_… bits of the lights there are: shaders leave out what only the others need.
    uint32_t light_kinds() const { return kinds_; }

private:
    void make_draw_buffers();
    void make_shadows();
    /// Uploads the cookies and profiles of placed_ and of the scene's other lights.
    void make_distributions();
    bool hold_maps_of(std::span<const PlacedLight> lights) const;
    /// Takes lights that there is no room or that there are no maps for, with buffers and maps for them; as before when
    /// it throws.
    void make_room(std::span<const PlacedLight> lights);
    void write_distributions();
    void update_shadows(const PlacedCamera& camera);
    /// Buffers for `lights` lights, and set 0 over all buffers.
    void make_light_buffers(size_t lights);
    const gpu::Context& context_;
    const World& world_;
    FrameSettings settings_;
    std::vector<PlacedLight> placed_;
    uint32_t kinds_ = 0;  ///< of placed_, found when they come: every frame may bring 65,536
    size_t capacity_ = 0; ///< lights that the buffers hold
    Materials materials_;
    std::vector<DecalBox> decals_;
    Geometry geometry_;
    /// What the host writes for one frame.
    struct Slot {
        gpu::Buffer lights, order, bounds, shadows, distributions;
        gpu::Buffer commands; ///< what find_visible() writes
    };
    gpu::PerFrame<Slot> slots_;
    gpu::PerFrame<gpu::Buffer> constants_;
    gpu::PerFrame<gpu::Buffer> objects_, trimmed_; ///< what find_visible() writes too
    std::optional<VisiblePixels> visible_pixels_;
    std::optional<DeviceTrimming> device_trimming_;
    uint32_t slot_ = 0; ///< of the last update()
    VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
    gpu::DescriptorSets sets_; ///< one a slot
    VisibleDraws visible_;
    LightGroups groups_;
    LightReach reach_;
    std::optional<ShadowPlan> shadows_;
    gpu::Buffer caster_rows_;
    gpu::UniqueSampler shadow_sampler_; ///< compares
    std::optional<DistributionMaps> distribution_maps_;
    /// The maps on the device; none where no light has one.
    struct UploadedMaps {
        explicit UploadedMaps(const gpu::Context& context) : pool(context) {}
        gpu::MemoryPool pool;
        std::optional<gpu::Texture> picture;
        gpu::Buffer levels;
        gpu::UniqueSampler sampler;
    };
    std::unique_ptr<UploadedMaps> uploaded_maps_;
    glm::dvec3 eye_{0};
    glm::mat4 clip_from_world_{1};
    UpdateTimes times_;
    double set_lights_ms_ = 0; ///< since the last update()
};

} // namespace prelight::resident
