#include "shadow_plan.hpp"
#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace prelight::resident {
namespace {

constexpr uint32_t longest_side = 4096;
/// Texels for a pixel across; fewer are worth a note.
constexpr double coarse = 0.125;
/// What contact hardening takes directional lights to be: the sun, 0.53° wide. Others have a size of their own.
constexpr double sun_radius = 0.00463;

uint32_t power_of_two(double texels, uint32_t most) {
    return std::min(std::bit_ceil(static_cast<uint32_t>(std::clamp(texels, 1.0, double(longest_side)))), most);
}

/// Pixels that a light's sphere measures across, at most those of the picture's longer side twice.
double pixels_across(const PlacedLight& light, const PlacedCamera& camera, uint32_t width, uint32_t height) {
    const double most = 2.0 * std::max(width, height);
    if (light.light.kind == LightKind::directional)
        return most;
    const double range = light.light.range, away = glm::distance(light.position, camera.position);
    if (camera.camera.kind == ProjectionKind::orthographic)
        return std::min(range / camera.camera.ymag * height, most);
    return away <= range ? most : std::min(range / away / std::tan(camera.camera.yfov / 2) * height, most);
}

} // namespace

ShadowPlan::ShadowPlan(std::span<const Draw> draws, const ShadowOptions& options, uint32_t longest)
    : draws_(draws), world_(box_around(draws)), options_(options), atlas_(options.budget, longest) {
    for (const Draw& draw : draws)
        versions_.push_back(draw.version);
}

void ShadowPlan::find_moved() {
    moved_.clear();
    for (uint32_t d = 0; d < draws_.size(); ++d)
        if (versions_[d] != draws_[d].version) {
            versions_[d] = draws_[d].version;
            moved_.push_back(d);
        }
    if (!moved_.empty())
        world_ = box_around(draws_);
}

bool ShadowPlan::casts(const Frustum& sight, uint32_t draw) const {
    if (!draws_[draw].visible || draws_[draw].transmissive())
        return false;
    if (options_.blended == TransparentShadows::none && draws_[draw].blended())
        return false;
    return sight.may_show(draws_[draw], world_.centre());
}

std::vector<uint32_t> ShadowPlan::casters_still(const ShadowSight& sight, std::vector<uint32_t> before) const {
    if (moved_.empty())
        return before;
    const Frustum frustum(sight.clip_from_centre);
    std::erase_if(before, [&](uint32_t d) { return std::binary_search(moved_.begin(), moved_.end(), d); });
    for (const uint32_t d : moved_)
        if (reaches(sight.light, draws_[d]) && casts(frustum, d))
            before.push_back(d);
    std::sort(before.begin(), before.end());
    return before;
}

/// The side of its tiles where a light has all texels for itself.
uint32_t ShadowPlan::largest_alone(uint32_t tiles) const {
    uint32_t side = atlas_.largest();
    while (side > 1 && uint64_t(tiles) * side * side > atlas_.texels())
        side /= 2;
    return side;
}

void ShadowPlan::wish(std::span<const PlacedLight> lights, std::span<const uint32_t> visible,
                      const PlacedCamera& camera, uint32_t width, uint32_t height) {
    wishes_.clear();
    for (const uint32_t index : visible) {
        const Light& light = lights[index].light;
        if (!light.casts_shadow)
            continue;
        Wish wish{.light = index, .tiles = shadow_tiles(light)};
        wish.pixels = pixels_across(lights[index], camera, width, height);
        wish.across = wish.pixels;
        if (wish.tiles == 1) // its cone is narrower than its sphere
            wish.across *= std::min(std::tan(double(light.outer_cone)), 1.0);
        wish.side = std::min(power_of_two(options_.detail * wish.across, atlas_.largest()), largest_alone(wish.tiles));
        wishes_.push_back(wish);
    }
}

void ShadowPlan::fit_budget() {
    std::stable_sort(wishes_.begin(), wishes_.end(), [](const Wish& a, const Wish& b) { return a.pixels < b.pixels; });
    uint64_t texels = 0;
    for (const Wish& wish : wishes_)
        texels += uint64_t(wish.tiles) * wish.side * wish.side;
    // Each halves once before one halves twice; the least important first.
    for (bool halved = true; halved && texels > atlas_.texels();) {
        halved = false;
        for (Wish& wish : wishes_) {
            if (texels <= atlas_.texels() || wish.side == 1)
                continue;
            texels -= uint64_t(wish.tiles) * wish.side * wish.side * 3 / 4;
            wish.side /= 2;
            halved = true;
        }
    }
    auto kept = wishes_.begin();
    for (; kept != wishes_.end() && texels > atlas_.texels(); ++kept)
        texels -= uint64_t(kept->tiles) * kept->side * kept->side;
    stats_.lights_without = static_cast<uint64_t>(kept - wishes_.begin());
    wishes_.erase(wishes_.begin(), kept);
    stats_.texels = texels;
}

void ShadowPlan::fit_each() {
    std::erase_if(wishes_, [&](Wish& wish) {
        const uint64_t texels = uint64_t(wish.tiles) * wish.side * wish.side;
        if (texels > atlas_.texels()) {
            ++stats_.lights_without;
            return true;
        }
        stats_.texels = std::max(stats_.texels, texels);
        return false;
    });
}

void ShadowPlan::place(std::vector<ShadowTilePlace>& places) {
    std::vector<ShadowAtlas::Wish> wanted;
    std::vector<ShadowTilePlace> own;
    for (const Wish& wish : wishes_) {
        for (uint32_t tile = 0; tile < wish.tiles; ++tile)
            wanted.push_back({{wish.light, tile}, wish.side});
        if (!options_.reuse)
            continue;
        atlas_.place(wanted, own);
        places.insert(places.end(), own.begin(), own.end());
        wanted.clear();
    }
    if (!options_.reuse)
        atlas_.place(wanted, places);
}

shared::ShadowData ShadowPlan::record(const Light& light, const ShadowView& view, const ShadowTilePlace& place,
                                      const PlacedCamera& camera) const {
    const bool directional = light.kind == LightKind::directional;
    shared::ShadowData out{};
    out.place = glm::vec4(place.corner, place.side, directional ? 0 : 1 / view.texel_per_w);
    out.scale.z = directional ? static_cast<float>(sun_radius) : light.size;
    if (!directional)
        return out;
    // From the camera's place to the world's centre, then clip space → texels.
    glm::dmat4 m = view.clip_from_centre * glm::translate(glm::dmat4(1), camera.position - world_.centre());
    const double half = 0.5 * place.side;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 2; ++row)
            m[column][row] = half * (m[column][row] + m[column][3]);
    const glm::dmat4 rows = glm::transpose(m);
    out.across = glm::vec4(rows[0]);
    out.down = glm::vec4(rows[1]);
    out.away = glm::vec4(rows[2]);
    out.scale.x = static_cast<float>(view.texel);
    out.scale.y = static_cast<float>(view.depth_range);
    out.ends = glm::vec4(cascade_ends(camera, world_));
    return out;
}

std::vector<uint32_t> ShadowPlan::casters_of(const ShadowSight& sight, std::span<const uint32_t> reached) const {
    const Frustum frustum(sight.clip_from_centre);
    std::vector<uint32_t> casters;
    for (const uint32_t d : reached)
        if (casts(frustum, d))
            casters.push_back(d);
    return casters;
}

void ShadowPlan::add_tiles(const Wish& wish, const PlacedLight& light, std::span<const ShadowView> views,
                           std::span<const ShadowTilePlace> places, const glm::dmat3& viewer,
                           std::vector<ShadowTile>::iterator& before) {
    const LightVolume volume(light);
    std::optional<std::vector<uint32_t>> reached; // once for all tiles of the light, where one is new
    while (before != before_.end() && before->light < wish.light)
        ++before;
    for (size_t i = 0; i < views.size(); ++i) {
        ShadowTile tile{.light = wish.light,
                        .number = static_cast<uint32_t>(i),
                        .cascade = light.light.kind == LightKind::directional,
                        .sight = {volume, glm::mat4(views[i].clip_from_centre)}};
        tile.map.place = places[i];
        tile.map.centre = world_.centre();
        tile.map.clip_from_centre = tile.sight.clip_from_centre;
        const bool known = before != before_.end() && before->light == wish.light;
        if (known && options_.cached && before->sight == tile.sight) {
            tile.map.casters = casters_still(tile.sight, std::move(before->map.casters));
        } else {
            if (!reached) {
                reached.emplace();
                for (uint32_t d = 0; d < draws_.size(); ++d)
                    if (reaches(volume, draws_[d]))
                        reached->push_back(d);
            }
            tile.map.casters = casters_of(tile.sight, *reached);
        }
        for (const uint32_t d : tile.map.casters) {
            tile.map.versions.push_back(versions_[d]);
            if (draws_[d].facing())
                tile.map.viewer = viewer;
        }
        if (known)
            ++before;
        tiles_.push_back(std::move(tile));
    }
}

void ShadowPlan::update(std::span<const PlacedLight> lights, std::span<const uint32_t> visible,
                        const PlacedCamera& camera, double aspect, uint32_t width, uint32_t height) {
    stats_ = {.budget = atlas_.texels()};
    find_moved();
    wish(lights, visible, camera, width, height);
    if (options_.reuse)
        fit_each();
    else
        fit_budget();
    std::sort(wishes_.begin(), wishes_.end(), [](const Wish& a, const Wish& b) { return a.light < b.light; });
    std::vector<ShadowTilePlace> places;
    place(places);

    std::swap(tiles_, before_);
    tiles_.clear();
    auto before = before_.begin();
    records_.clear();
    lights_.clear();
    sun_.reset();
    std::vector<ShadowView> views;
    stats_.lights = wishes_.size();
    stats_.smallest = wishes_.empty() ? 0 : ~0u;
    for (const Wish& wish : wishes_) {
        const PlacedLight& light = lights[wish.light];
        const uint32_t guard = shared::shadow_guard(static_cast<uint32_t>(options_.filter), wish.side);
        find_shadow_views(light, camera, aspect, world_, wish.side, guard, views);
        lights_.push_back({wish.light, static_cast<uint32_t>(tiles_.size()), shadow_kind(light.light)});
        if (!sun_ && light.light.kind == LightKind::directional)
            sun_ = lights_.back();
        const std::span own = std::span(places).subspan(tiles_.size(), views.size());
        for (size_t i = 0; i < views.size(); ++i)
            records_.push_back(record(light.light, views[i], own[i], camera));
        add_tiles(wish, light, views, own, camera.axes, before);
        stats_.lights_reduced += wish.side < coarse * std::min(options_.detail, 1.0) *
                                                 std::min(wish.across, double(std::max(width, height)));
        stats_.smallest = std::min(stats_.smallest, wish.side);
        stats_.largest = std::max(stats_.largest, wish.side);
    }
}

} // namespace prelight::resident
