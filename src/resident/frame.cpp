#include "frame.hpp"
#include "projection.hpp"
#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <memory>
#include <prelight/error.hpp>
#include <prelight/light_distribution.hpp>
#include <shared/bindings.h>
#include <timing/clocks.hpp>
#include <utility>

namespace prelight::resident {
namespace {

constexpr float half_max = 65504;
/// Trimmed indices of a frame, 64 MiB: beyond that objects are drawn whole.
constexpr uint64_t most_trimmed = 16u << 20;

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

uint32_t kinds_of(std::span<const PlacedLight> lights) {
    uint32_t kinds = 0;
    for (const PlacedLight& placed : lights) {
        const Light& light = placed.light;
        kinds |= light.kind == LightKind::spot ? LIGHT_KIND_SPOT : 0;
        kinds |= light.kind == LightKind::directional ? LIGHT_KIND_DIRECTIONAL : 0;
        kinds |= light.falloff != Falloff::gltf ? LIGHT_KIND_SEED_FALLOFF : 0;
        kinds |= has_distribution(light) ? LIGHT_KIND_DISTRIBUTION : 0;
    }
    return kinds;
}

/// All of a light but its name, which nobody needs here: text would cost more than the rest. Fields have names of their
/// own, for then one that is added to Light or PlacedLight does not compile until it is placed too.
void place(PlacedLight& target, const PlacedLight& from) {
    auto& [light, position, direction, up] = target;
    auto& [name, kind, colour, intensity, range, inner_cone, outer_cone, shininess, falloff, casts_shadow, cookie,
           profile, profile_candela, size] = light;
    kind = from.light.kind;
    colour = from.light.colour;
    intensity = from.light.intensity;
    range = from.light.range;
    inner_cone = from.light.inner_cone;
    outer_cone = from.light.outer_cone;
    shininess = from.light.shininess;
    falloff = from.light.falloff;
    casts_shadow = from.light.casts_shadow;
    cookie = from.light.cookie;
    if (profile != from.light.profile)
        profile = from.light.profile;
    profile_candela = from.light.profile_candela;
    size = from.light.size;
    position = from.position;
    direction = from.direction;
    up = from.up;
}

} // namespace

Frame::Frame(const gpu::Context& context, const World& world, const FrameSettings& settings)
    : context_(context), world_(world), settings_(settings), placed_(world.lights), kinds_(kinds_of(placed_)),
      materials_(upload_materials(context, *world.scene, settings.texture_filter, settings.exposure)),
      decals_(decal_boxes(world)),
      geometry_(upload_geometry(context, world, settings.motion, settings.draws.trims_on_device(), materials_.shaders,
                                decals_)) {
    for (gpu::Buffer& constants : constants_)
        constants = gpu::Buffer(context_, "frame constants", sizeof(shared::FrameConstants),
                                VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT |
                                    (settings.measures_light ? VK_BUFFER_USAGE_STORAGE_BUFFER_BIT : 0),
                                gpu::BufferPlace::upload);
    make_draw_buffers();
    if (settings_.shadows.on)
        make_shadows();
    check_lights(*world.scene, placed_);
    make_distributions();
    make_light_buffers(placed_.size());
}

void Frame::make_distributions() {
    std::vector<PlacedLight> with_one;
    std::copy_if(placed_.begin(), placed_.end(), std::back_inserter(with_one),
                 [](const PlacedLight& placed) { return has_distribution(placed.light); });
    for (const Light& light : world_.scene->lights) // may come in later
        if (has_distribution(light)) {
            check_light(*world_.scene, light, fmt::format("{}: light {}", world_.scene->name, light.name));
            with_one.push_back({light, glm::dvec3(0)});
        }
    DistributionMaps maps(*world_.scene, with_one, context_.limits().maxImageDimension2D);
    std::unique_ptr<UploadedMaps> made;
    if (!maps.empty()) {
        made = std::make_unique<UploadedMaps>(context_);
        gpu::Uploader uploader(context_);
        made->picture.emplace(context_, made->pool, uploader, "light distributions", std::vector{maps.picture()});
        made->levels = gpu::make_device_buffer(context_, "light distribution levels", std::as_bytes(maps.levels()),
                                               VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
        made->sampler = gpu::make_sampler(context_, {.wrap_s = Wrap::clamp_to_edge, .wrap_t = Wrap::clamp_to_edge},
                                          gpu::TextureFilter::bilinear);
        uploader.finish();
    }
    distribution_maps_.emplace(std::move(maps));
    uploaded_maps_ = std::move(made);
}

void Frame::make_draw_buffers() {
    const auto make = [&](const char* name, uint64_t bytes, VkBufferUsageFlags usage) {
        return gpu::Buffer(context_, name, std::max<uint64_t>(bytes, 4), usage, gpu::BufferPlace::upload);
    };
    const uint64_t draws = geometry_.draws.size();
    uint64_t indices = 0;
    for (const Draw& draw : geometry_.draws)
        indices += draw.index_count;
    indices = std::min(indices, most_trimmed);
    const DrawOptions& options = settings_.draws;
    const VkBufferUsageFlags storage = options.trims_on_device() ? VK_BUFFER_USAGE_STORAGE_BUFFER_BIT : 0;
    const uint64_t host_indices = options.trimming == IndexTrimming::host ? indices : 0;
    for (uint32_t slot = 0; slot < gpu::frames_in_flight; ++slot) {
        objects_[slot] =
            make("objects", draws * sizeof(shared::ObjectData), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | storage);
        slots_[slot].commands =
            make("draw commands", draws * sizeof(VkDrawIndexedIndirectCommand), VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT);
        trimmed_[slot] =
            make("trimmed indices", host_indices * sizeof(uint32_t), VK_BUFFER_USAGE_INDEX_BUFFER_BIT | storage);
    }
    if (options.counts_pixels)
        visible_pixels_.emplace(context_, static_cast<uint32_t>(draws));
    if (options.trims_on_device())
        device_trimming_.emplace(context_, geometry_, indices, options);
}

uint64_t Frame::triangles_drawn() const {
    const bool on_device = settings_.draws.trimming == IndexTrimming::device;
    if (!on_device)
        return visible_.triangles;
    uint64_t triangles = device_trimming_->first().triangles(slot_, visible_.draws.size());
    for (const VisibleDraw& one : visible_.draws)
        triangles += one.device_trimmed ? 0 : one.index_count / 3;
    return triangles;
}

std::optional<uint64_t> Frame::draws_skipped() const {
    if (!visible_pixels_)
        return {};
    return visible_pixels_->hidden(slot_, static_cast<uint32_t>(visible_.batches.size()));
}

std::optional<uint64_t> Frame::triangles_skipped() const {
    if (!settings_.draws.trims_by_depth)
        return {};
    uint64_t later = device_trimming_->later().triangles(slot_, visible_.draws.size());
    for (const VisibleDraw& one : visible_.draws)
        later += one.device_trimmed ? 0 : one.index_count / 3;
    return triangles_drawn() - later;
}

void Frame::make_shadows() {
    shadows_.emplace(geometry_.draws, settings_.shadows, context_.limits().maxImageDimension2D);
    std::vector<std::array<glm::vec4, 3>> rows;
    for (const Draw& draw : geometry_.draws) {
        glm::dmat4 m = world_.instances[draw.object].transform;
        m[3] -= glm::dvec4(shadows_->world().centre(), 0);
        m = glm::transpose(m);
        rows.push_back({glm::vec4(m[0]), glm::vec4(m[1]), glm::vec4(m[2])});
    }
    caster_rows_ = gpu::make_device_buffer(context_, "shadow casters", std::as_bytes(std::span(rows)),
                                           VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    shadow_sampler_ = gpu::make_compare_sampler(context_, VK_FORMAT_D32_SFLOAT);
}

void Frame::make_light_buffers(size_t lights) {
    constexpr auto storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    const size_t bounded = culling() == LightCulling::rectangles ? lights : 1;
    gpu::PerFrame<Slot> made;
    for (Slot& slot : made) { // all of it before anything is replaced
        slot.lights = make_upload(context_, "lights", lights, sizeof(shared::LightData), storage);
        slot.order = make_upload(context_, "light order", lights, sizeof(uint32_t), storage);
        slot.bounds = make_upload(context_, "light bounds", bounded, sizeof(shared::LightScreenBounds), storage);
        if (uploaded_maps_)
            slot.distributions =
                make_upload(context_, "light distributions", lights, sizeof(shared::DistributionData), storage);
        if (shadows_) // as if all were point lights, for each may become one
            slot.shadows = make_upload(context_, "shadow tiles", 6 * lights, sizeof(shared::ShadowData), storage);
    }
    std::vector<std::vector<gpu::Binding>> sets;
    for (uint32_t s = 0; s < gpu::frames_in_flight; ++s)
        sets.push_back({gpu::Binding::uniform(FRAME_CONSTANTS, constants_[s].handle()),
                        gpu::Binding::storage(FRAME_LIGHTS, made[s].lights.handle()),
                        gpu::Binding::storage(FRAME_LIGHT_ORDER, made[s].order.handle()),
                        gpu::Binding::storage(FRAME_LIGHT_BOUNDS, made[s].bounds.handle())});
    for (uint32_t s = 0; s < gpu::frames_in_flight; ++s) {
        // Every binding is written, with whatever is there where no shader looks.
        const UploadedMaps* maps = uploaded_maps_.get();
        sets[s].push_back(gpu::Binding::storage(FRAME_DISTRIBUTIONS,
                                                maps ? made[s].distributions.handle() : made[s].bounds.handle()));
        sets[s].push_back(
            gpu::Binding::storage(FRAME_DISTRIBUTION_LEVELS, maps ? maps->levels.handle() : made[s].bounds.handle()));
        sets[s].push_back(gpu::Binding::texture(
            FRAME_DISTRIBUTION_MAPS, maps ? maps->picture->view() : materials_.environment->view(),
            maps ? VkSampler(maps->sampler) : VkSampler(materials_.environment_sampler)));
    }
    for (uint32_t s = 0; shadows_ && s < gpu::frames_in_flight; ++s) {
        sets[s].push_back(gpu::Binding::storage(FRAME_SHADOWS, made[s].shadows.handle()));
        sets[s].push_back(gpu::Binding::sampler_only(FRAME_SHADOW_SAMPLER, shadow_sampler_));
    }
    if (!layout_)
        layout_ = gpu::make_set_layout(context_, "frame", sets[0]);
    sets_ = gpu::DescriptorSets(context_, "frame", layout_, sets);
    for (uint32_t s = 0; s < gpu::frames_in_flight; ++s) {
        slots_[s].lights = std::move(made[s].lights);
        slots_[s].order = std::move(made[s].order);
        slots_[s].bounds = std::move(made[s].bounds);
        slots_[s].shadows = std::move(made[s].shadows);
        slots_[s].distributions = std::move(made[s].distributions);
    }
    capacity_ = lights;
}

bool Frame::hold_maps_of(std::span<const PlacedLight> lights) const {
    return std::all_of(lights.begin(), lights.end(), [&](const PlacedLight& light) {
        return !has_distribution(light.light) || distribution_maps_->hold(light.light);
    });
}

void Frame::make_room(std::span<const PlacedLight> lights) {
    std::vector<PlacedLight> placed(lights.begin(), lights.end());
    std::unique_ptr<UploadedMaps> uploaded;
    std::optional<DistributionMaps> maps;
    const bool known_maps = hold_maps_of(lights), grows = lights.size() > capacity_;
    const auto exchange = [&] { // what was and what is to be; back again when something throws
        std::swap(placed_, placed);
        if (known_maps)
            return;
        std::swap(uploaded_maps_, uploaded);
        std::swap(distribution_maps_, maps);
    };
    exchange();
    try {
        if (!known_maps)
            make_distributions();
        // With some room, so that adding one at a time is cheap.
        const size_t most = context_.limits().maxStorageBufferRange / sizeof(shared::LightData);
        make_light_buffers(grows ? std::max(lights.size(), std::min(capacity_ + capacity_ / 4 + 16, most)) : capacity_);
    } catch (...) {
        exchange();
        throw;
    }
}

bool Frame::set_lights(std::span<const PlacedLight> lights, const std::function<void()>& wait) {
    const double start = thread_ms();
    check_lights(*world_.scene, lights);
    const bool fits = lights.size() <= capacity_ && hold_maps_of(lights);
    if (fits) {
        placed_.resize(lights.size());
        for (size_t i = 0; i < lights.size(); ++i)
            place(placed_[i], lights[i]);
    } else {
        if (wait)
            wait();
        make_room(lights);
    }
    const uint32_t known = std::exchange(kinds_, kinds_of(placed_));
    const bool as_before = fits && (kinds_ & ~known) == 0;
    set_lights_ms_ += thread_ms() - start;
    return as_before;
}

void Frame::update(const PlacedCamera& camera, uint32_t slot) {
    slot_ = slot;
    const Slot& target = slots_[slot];
    shared::FrameConstants next{};
    eye_ = camera.position;
    fill_camera(next, camera, settings_.width, settings_.height);
    // One light is clamped at the largest half float, and what is stored is divided by light_scale, so
    // that blended sums of that many such lights stay finite.
    const glm::vec3 ambient = environment() ? glm::vec3(0) : world_.ambient; // the environment is in its place
    next.ambient = glm::vec4(ambient * static_cast<float>(settings_.exposure),
                             half_max / static_cast<float>(settings_.light_scale));
    next.light_buffer = glm::vec4(settings_.light_scale, settings_.exposure, settings_.light_scale, 0);
    *constants_[slot].mapped<shared::FrameConstants>() = next;
    clip_from_world_ = next.clip_from_world;

    const double start = thread_ms();
    shared::LightData* lights = target.lights.mapped<shared::LightData>();
    for (size_t i = 0; i < placed_.size(); ++i)
        lights[i] = light_data(placed_[i], camera.position, settings_.exposure);
    if (kinds_ & LIGHT_KIND_DISTRIBUTION)
        write_distributions();
    const double lights_end = thread_ms();
    const std::span trimmed(trimmed_[slot].mapped<uint32_t>(), trimmed_[slot].size() / sizeof(uint32_t));
    find_visible(visible_, geometry_, world_, next, eye_, context_.limits().subPixelPrecisionBits, settings_.draws,
                 {objects_[slot].mapped<shared::ObjectData>(), target.commands.mapped<VkDrawIndexedIndirectCommand>(),
                  trimmed, most_trimmed});
    if (device_trimming_)
        device_trimming_->update(slot, visible_, geometry_);
    const double objects_end = thread_ms();
    groups_ = group_lights(placed_, camera, next, settings_.culling, context_.features().depth_clamp,
                           settings_.volumes.spot_boxes);
    std::copy(groups_.order.begin(), groups_.order.end(), target.order.mapped<uint32_t>());
    std::copy(groups_.bounds.begin(), groups_.bounds.end(), target.bounds.mapped<shared::LightScreenBounds>());
    if (shadows_)
        update_shadows(camera);
    reach_ = find_reach(geometry_.draws, placed_, groups_.order, settings_.object_lights);
    times_ = {.lights = std::exchange(set_lights_ms_, 0.0) + lights_end - start,
              .culling = thread_ms() - objects_end,
              .objects = objects_end - lights_end};
}

void Frame::write_distributions() {
    const Slot& target = slots_[slot_];
    shared::DistributionData* records = target.distributions.mapped<shared::DistributionData>();
    uint32_t number = 0;
    for (size_t i = 0; i < placed_.size(); ++i) {
        if (!has_distribution(placed_[i].light))
            continue;
        records[number++] = distribution_maps_->record(placed_[i]);
        target.lights.mapped<shared::LightData>()[i].position.w = 1 + static_cast<float>(number);
    }
}

void Frame::update_shadows(const PlacedCamera& camera) {
    const Slot& target = slots_[slot_];
    shadows_->update(placed_, groups_.order, camera, settings_.width, settings_.height);
    if (const auto sun = shadows_->sun())
        constants_[slot_].mapped<shared::FrameConstants>()->sun = glm::vec4(sun->second + 1, sun->first, 0, 0);
    const std::vector<shared::ShadowData>& records = shadows_->records();
    std::copy(records.begin(), records.end(), target.shadows.mapped<shared::ShadowData>());
    for (const auto& [light, first] : shadows_->lights()) {
        const shared::LightData data = light_data(placed_[light], camera.position, settings_.exposure);
        target.lights.mapped<shared::LightData>()[light].cone.z = data.cone.z + 4 * static_cast<float>(first + 1);
    }
}

} // namespace prelight::resident
