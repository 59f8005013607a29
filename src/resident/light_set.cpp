#include "light_set.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <prelight/light_distribution.hpp>
#include <shared/bindings.h>

namespace prelight::resident {
namespace {

uint32_t kinds_of(std::span<const PlacedLight> lights) {
    uint32_t kinds = 0;
    for (const PlacedLight& placed : lights) {
        const Light& light = placed.light;
        kinds |= light.kind == LightKind::spot ? LIGHT_KIND_SPOT : 0;
        kinds |= light.kind == LightKind::directional ? LIGHT_KIND_DIRECTIONAL : 0;
        kinds |= light.falloff != Falloff::gltf ? LIGHT_KIND_OTHER_FALLOFF : 0;
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

LightSet::LightSet(const GpuScene& scene, std::span<const PlacedLight> lights, size_t capacity)
    : scene_(&scene), placed_(lights.begin(), lights.end()), kinds_(kinds_of(lights)), capacity_(capacity) {
    spheres_.assign(placed_);
}

LightSet::LightSet(const GpuScene& scene) : LightSet(scene, scene.world().lights, scene.world().lights.size()) {
    check_lights(*scene.world().scene, placed_);
    upload_maps();
}

LightSet LightSet::with(std::span<const PlacedLight> lights) const {
    const size_t most = scene_->context().limits().maxStorageBufferRange / sizeof(shared::LightData);
    const size_t roomy = std::min(capacity_ + capacity_ / 4 + 16, most);
    LightSet next(*scene_, lights, lights.size() <= capacity_ ? capacity_ : std::max(lights.size(), roomy));
    next.version_ = version_ + 1;
    if (has_maps_of(lights)) {
        next.maps_ = maps_;
        next.uploaded_ = uploaded_;
    } else {
        next.upload_maps();
    }
    return next;
}

void LightSet::upload_maps() {
    const Scene& scene = *scene_->world().scene;
    const gpu::Context& context = scene_->context();
    std::vector<PlacedLight> with_one;
    std::copy_if(placed_.begin(), placed_.end(), std::back_inserter(with_one),
                 [](const PlacedLight& placed) { return has_distribution(placed.light); });
    for (const Light& light : scene.lights)
        if (has_distribution(light)) {
            check_light(scene, light, fmt::format("{}: light {}", scene.name, light.name));
            with_one.push_back({light, glm::dvec3(0)});
        }
    const auto maps = std::make_shared<DistributionMaps>(scene, with_one, context.limits().maxImageDimension2D);
    if (!maps->empty()) {
        const auto made = std::make_shared<UploadedMaps>(context);
        gpu::Uploader uploader(context);
        made->picture.emplace(context, made->pool, uploader, "light distributions", std::vector{maps->picture()});
        made->levels = gpu::make_device_buffer(context, "light distribution levels", std::as_bytes(maps->levels()),
                                               VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
        made->sampler = gpu::make_sampler(context, {.wrap_s = Wrap::clamp_to_edge, .wrap_t = Wrap::clamp_to_edge},
                                          gpu::TextureFilter::bilinear);
        uploader.finish();
        uploaded_ = made;
    }
    maps_ = maps;
}

bool LightSet::has_maps_of(std::span<const PlacedLight> lights) const {
    return std::all_of(lights.begin(), lights.end(), [&](const PlacedLight& light) {
        return !has_distribution(light.light) || maps_->hold(light.light);
    });
}

bool LightSet::holds(std::span<const PlacedLight> lights) const {
    return lights.size() <= capacity_ && has_maps_of(lights);
}

void LightSet::replace(std::span<const PlacedLight> lights) {
    placed_.resize(lights.size());
    for (size_t i = 0; i < lights.size(); ++i)
        place(placed_[i], lights[i]);
    kinds_ = kinds_of(placed_);
    spheres_.assign(placed_);
    ++version_;
}

} // namespace prelight::resident
