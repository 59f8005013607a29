#include "view.hpp"
#include "projection.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <memory>
#include <platform/clocks.hpp>
#include <prelight/error.hpp>
#include <prelight/light_distribution.hpp>
#include <shared/bindings.h>
#include <utility>

namespace prelight::resident {
namespace {

constexpr float half_max = 65504;
/// Trimmed indices of a frame, 64 MiB: beyond that objects are drawn whole.
constexpr uint64_t most_trimmed = 16u << 20;
/// Those of shadow casters, 32 MiB: all that is left of 80 million triangles of the scene `lights` with 1,024 lights.
constexpr uint64_t most_trimmed_casters = 8u << 20;

gpu::Buffer make_upload(const gpu::Context& context, const char* name, uint64_t count, uint64_t stride,
                        VkBufferUsageFlags usage) {
    const uint64_t size = std::max<uint64_t>(count, 1) * stride;
    const uint64_t limit = context.limits().maxStorageBufferRange;
    if (size > limit)
        throw Error(fmt::format("{}: {} {} need a buffer of {} bytes, and the device's limit is {}", context.name(),
                                count, name, size, limit));
    gpu::Buffer buffer(context, name, size, usage, gpu::BufferPlace::upload);
    std::memset(buffer.mapped<std::byte>(), 0, size); // shaders may read a record that no frame has written
    return buffer;
}

} // namespace

View::View(const GpuScene& scene, const LightSet& lights, const ViewSettings& settings)
    : scene_(scene), lights_(lights), settings_(settings) {
    for (gpu::Buffer& constants : constants_)
        constants = gpu::Buffer(context(), "frame constants", sizeof(shared::FrameConstants),
                                VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                                    (settings.measures_light ? VK_BUFFER_USAGE_STORAGE_BUFFER_BIT : 0),
                                gpu::BufferPlace::upload);
    make_draw_buffers();
    if (settings.layer_decals && LayerDecals::wanted(scene))
        layer_decals_.emplace(scene);
    if (settings_.shadows.on) {
        shadows_.emplace(scene.geometry().draws, settings_.shadows, context().limits().maxImageDimension2D);
        shadow_sampler_ = gpu::make_compare_sampler(context(), VK_FORMAT_D32_SFLOAT);
    }
    make_light_buffers(lights);
}

void View::make_draw_buffers() {
    const auto make = [&](const char* name, uint64_t bytes, VkBufferUsageFlags usage) {
        return gpu::Buffer(context(), name, std::max<uint64_t>(bytes, 4), usage, gpu::BufferPlace::upload);
    };
    const uint64_t draws = scene_.geometry().draws.size();
    uint64_t indices = 0, facing = 0;
    for (const Draw& draw : scene_.geometry().draws) {
        indices += draw.index_count;
        facing += draw.facing() ? draw.index_count : 0;
    }
    indices = std::min(indices, most_trimmed);
    const DrawOptions& options = settings_.draws;
    const VkBufferUsageFlags storage = options.trims_on_device() ? VK_BUFFER_USAGE_STORAGE_BUFFER_BIT : 0;
    const uint64_t host_indices = options.trimming == IndexTrimming::host ? indices : std::min(facing, most_trimmed);
    const bool casters = settings_.shadows.on && !settings_.shadows.reuse && options.trimming == IndexTrimming::host;
    const uint64_t caster_indices = casters ? std::min(6 * lights_.capacity() * indices, most_trimmed_casters) : 0;
    for (uint32_t slot = 0; slot < gpu::frames_in_flight; ++slot) {
        caster_indices_[slot] =
            make("caster indices", caster_indices * sizeof(uint32_t), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
        objects_[slot] =
            make("objects", draws * sizeof(shared::ObjectData), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | storage);
        slots_[slot].commands =
            make("draw commands", draws * sizeof(VkDrawIndexedIndirectCommand), VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT);
        trimmed_[slot] =
            make("trimmed indices", host_indices * sizeof(uint32_t), VK_BUFFER_USAGE_INDEX_BUFFER_BIT | storage);
    }
    if (options.counts_pixels)
        visible_pixels_.emplace(context(), static_cast<uint32_t>(draws));
    if (options.trims_on_device())
        device_trimming_.emplace(context(), scene_.geometry(), indices, options);
}

uint64_t View::triangles_drawn() const {
    const bool on_device = settings_.draws.trimming == IndexTrimming::device;
    if (!on_device)
        return visible_.triangles;
    return device_trimming_->first().triangles(slot_, visible_.draws);
}

std::optional<uint64_t> View::draws_skipped() const {
    if (!visible_pixels_)
        return {};
    return visible_pixels_->hidden(slot_, static_cast<uint32_t>(visible_.batches.size()));
}

std::optional<uint64_t> View::triangles_skipped() const {
    if (!settings_.draws.trims_by_depth)
        return {};
    return triangles_drawn() - device_trimming_->later().triangles(slot_, visible_.draws);
}

void View::make_light_buffers(const LightSet& lights) {
    constexpr auto storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const size_t room = lights.capacity(), bounded = culling() == LightCulling::rectangles ? room : 1;
    gpu::PerFrame<Slot> made;
    for (Slot& slot : made) { // all of it before anything is replaced
        slot.lights = make_upload(context(), "lights", room, sizeof(shared::LightData),
                                  storage | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
        slot.light_texels = gpu::make_texel_view(context(), "lights as texels", slot.lights);
        slot.order = make_upload(context(), "light order", room, sizeof(uint32_t), storage);
        slot.bounds = make_upload(context(), "light bounds", bounded, sizeof(shared::LightScreenBounds), storage);
        if (lights.distribution_picture())
            slot.distributions =
                make_upload(context(), "light distributions", room, sizeof(shared::DistributionData), storage);
        if (shadows_) // as if all were point lights, for each may become one
            slot.shadows = make_upload(context(), "shadow tiles", 6 * room, sizeof(shared::ShadowData),
                                       storage | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
        if (shadows_)
            slot.shadow_texels = gpu::make_texel_view(context(), "shadow tiles as texels", slot.shadows);
    }
    std::vector<std::vector<gpu::Binding>> sets;
    for (uint32_t s = 0; s < gpu::frames_in_flight; ++s) {
        // FRAME_UNREAD: lavapipe notes which values of a stage's first four uniform buffers decide branches, and its
        // notes of the fourth overwrite others. With three that no shader reads, nothing that is read is the fourth.
        const VkBuffer constants = constants_[s].handle();
        sets.push_back(
            {gpu::Binding::uniform(FRAME_CONSTANTS, constants), gpu::Binding::uniform(FRAME_UNREAD, constants),
             gpu::Binding::uniform(FRAME_UNREAD + 1, constants), gpu::Binding::uniform(FRAME_UNREAD + 2, constants),
             gpu::Binding::storage(FRAME_LIGHTS, made[s].lights.handle()),
             gpu::Binding::storage(FRAME_LIGHT_ORDER, made[s].order.handle()),
             gpu::Binding::storage(FRAME_LIGHT_BOUNDS, made[s].bounds.handle()),
             gpu::Binding::texel_buffer(FRAME_LIGHT_TEXELS, made[s].light_texels)});
        // Every binding is written, with whatever is there where no shader looks.
        const gpu::Texture* picture = lights.distribution_picture();
        const Materials& materials = scene_.materials();
        const VkBuffer none = made[s].bounds.handle();
        sets[s].insert(
            sets[s].end(),
            {gpu::Binding::storage(FRAME_DISTRIBUTIONS, picture ? made[s].distributions.handle() : none),
             gpu::Binding::storage(FRAME_DISTRIBUTION_LEVELS, picture ? lights.distribution_levels() : none),
             gpu::Binding::texture(FRAME_DISTRIBUTION_MAPS, picture ? picture->view() : materials.environment->view(),
                                   picture ? lights.distribution_sampler() : materials.environment_sampler)});
    }
    for (uint32_t s = 0; shadows_ && s < gpu::frames_in_flight; ++s) {
        sets[s].push_back(gpu::Binding::storage(FRAME_SHADOWS, made[s].shadows.handle()));
        sets[s].push_back(gpu::Binding::texel_buffer(FRAME_SHADOW_TEXELS, made[s].shadow_texels));
        sets[s].push_back(gpu::Binding::sampler_only(FRAME_SHADOW_SAMPLER, shadow_sampler_));
    }
    if (!layout_)
        layout_ = gpu::make_set_layout(context(), "frame", sets[0]);
    sets_ = gpu::DescriptorSets(context(), "frame", layout_, sets);
    for (uint32_t s = 0; s < gpu::frames_in_flight; ++s) {
        slots_[s].lights = std::move(made[s].lights);
        slots_[s].light_texels = std::move(made[s].light_texels);
        slots_[s].order = std::move(made[s].order);
        slots_[s].bounds = std::move(made[s].bounds);
        slots_[s].shadows = std::move(made[s].shadows);
        slots_[s].shadow_texels = std::move(made[s].shadow_texels);
        slots_[s].distributions = std::move(made[s].distributions);
        slots_[s].written = {};
    }
}

void View::update(const PlacedCamera& camera, uint32_t slot) {
    slot_ = slot;
    const Slot& target = slots_[slot];
    shared::FrameConstants next{};
    eye_ = camera.position;
    const VkExtent2D extent = raster().extent;
    fill_camera(next, camera, frame().width, frame().height);
    // One light is clamped at the largest half float, and what is stored is divided by light_scale, so
    // that blended sums of that many such lights stay finite.
    const World& world = scene_.world();
    const glm::vec3 ambient = scene_.environment() ? glm::vec3(0) : world.ambient; // the environment is in its place
    next.ambient = glm::vec4(ambient * static_cast<float>(settings_.exposure),
                             half_max / static_cast<float>(settings_.light_scale));
    next.light_buffer = glm::vec4(settings_.light_scale, settings_.exposure, settings_.light_scale, 0);
    clip_from_world_ = next.clip_from_world;

    const double start = thread_ms();
    const std::span trimmed(trimmed_[slot].mapped<uint32_t>(), trimmed_[slot].size() / sizeof(uint32_t));
    find_visible(visible_, scene_.geometry(), world, next, surface_raster(), eye_,
                 context().limits().subPixelPrecisionBits, settings_.draws,
                 {objects_[slot].mapped<shared::ObjectData>(), target.commands.mapped<VkDrawIndexedIndirectCommand>(),
                  trimmed, most_trimmed});
    if (device_trimming_)
        device_trimming_->update(slot, visible_, scene_.geometry());
    const double objects_end = thread_ms();
    groups_ = group_lights(lights_.placed(), lights_.spheres(), camera, next, aspect(), extent, settings_.culling,
                           context().features().depth_clamp, settings_.volumes.spot_boxes);
    if (settings_.layers)
        find_layer_slots(layers_, scene_.geometry(), world, next, eye_, extent);
    std::copy(groups_.order.begin(), groups_.order.end(), target.order.mapped<uint32_t>());
    std::copy(groups_.bounds.begin(), groups_.bounds.end(), target.bounds.mapped<shared::LightScreenBounds>());
    if (layer_decals_)
        layer_decals_->update(scene_, eye_, slot);
    if (shadows_)
        update_shadows(camera, next);
    reach_ = find_reach(scene_.geometry().draws, lights_.placed(), groups_.order, settings_.object_lights,
                        finds_blended_lights_ ? ObjectLights::world_order : ObjectLights::none);
    *constants_[slot].mapped<shared::FrameConstants>() = next;
    const double culling_end = thread_ms();
    written_ = sizeof next + write_lights() + groups_.order.size() * sizeof(uint32_t) +
               groups_.bounds.size() * sizeof(shared::LightScreenBounds) +
               visible_.draws.size() * sizeof(shared::ObjectData) +
               visible_.batches.size() * sizeof(VkDrawIndexedIndirectCommand) + visible_.trimmed * sizeof(uint32_t);
    if (shadows_)
        written_ += shadows_->records().size() * sizeof(shared::ShadowData);
    times_ = {.lights = thread_ms() - culling_end,
              .culling = culling_end - objects_end,
              .objects = objects_end - start + visible_.helpers_ms};
}

void View::update_shadows(const PlacedCamera& camera, shared::FrameConstants& constants) {
    shadows_->update(lights_.placed(), groups_.order, camera, aspect(), raster().extent.width, raster().extent.height);
    if (const auto sun = shadows_->sun())
        constants.sun = glm::vec4(sun->number(), sun->light, 0, 0);
    const std::vector<shared::ShadowData>& records = shadows_->records();
    std::copy(records.begin(), records.end(), slots_[slot_].shadows.mapped<shared::ShadowData>());
}

/// What the slot holds already is not written again: 65,536 lights are 4 MB. Returns the bytes.
uint64_t View::write_lights() {
    Slot& slot = slots_[slot_];
    shared::LightData* const records = slot.lights.mapped<shared::LightData>();
    const bool same_lights = slot.written.lights == lights_.version(), same_eye = slot.written.eye == eye_;
    uint64_t bytes = 0;
    if (!same_lights) {
        bytes = write_records(records);
    } else {
        if (!same_eye)
            bytes = write_positions(records);
        for (const uint32_t light : slot.written.shadowed)
            records[light].shadow = 0;
    }
    slot.written.lights = lights_.version();
    slot.written.eye = eye_;
    slot.written.shadowed.clear();
    for (const ShadowedLight& one : shadows_ ? std::span(shadows_->lights()) : std::span<const ShadowedLight>()) {
        records[one.light].shadow = one.number();
        slot.written.shadowed.push_back(one.light);
    }
    return bytes + slot.written.shadowed.size() * sizeof(uint32_t);
}

/// Each record once, front to back: the memory may be write-combined.
uint64_t View::write_records(shared::LightData* records) {
    const std::span<const PlacedLight> lights = lights_.placed();
    shared::DistributionData* const distributions =
        lights_.distribution_picture() ? slots_[slot_].distributions.mapped<shared::DistributionData>() : nullptr;
    uint32_t distributed = 0;
    for (uint32_t i = 0; i < lights.size(); ++i) {
        shared::LightData record = light_data(lights[i], eye_, settings_.exposure);
        if (has_distribution(lights[i].light)) {
            distributions[distributed] = lights_.distribution(lights[i]);
            record.kind |= ++distributed << LIGHT_DISTRIBUTION_SHIFT;
        }
        records[i] = record;
    }
    return lights.size() * sizeof(shared::LightData) + distributed * sizeof(shared::DistributionData);
}

/// All that of the records depends on the eye.
uint64_t View::write_positions(shared::LightData* records) const {
    const std::span<const PlacedLight> lights = lights_.placed();
    const LightSpheres& spheres = lights_.spheres();
    for (uint32_t i = 0; i < lights.size(); ++i)
        if (std::abs(spheres.radius[i]) != LightSpheres::endless || lights[i].light.kind != LightKind::directional)
            records[i].position = glm::dvec3(spheres.x[i], spheres.y[i], spheres.z[i]) - eye_;
    return lights.size() * sizeof(glm::vec3);
}

} // namespace prelight::resident
