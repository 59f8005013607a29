#include "distribution_maps.hpp"
#include "map_levels.hpp"
#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <prelight/error.hpp>
#include <shared/bindings.h>

namespace prelight::resident {
namespace {

using std::numbers::pi;

int cookie_code(CookieKind kind) {
    switch (kind) {
    case CookieKind::none: break;
    case CookieKind::spot: return COOKIE_SPOT;
    case CookieKind::sphere: return COOKIE_SPHERE;
    case CookieKind::cube: return COOKIE_CUBE;
    }
    return COOKIE_NONE;
}

/// Corners of rectangles that lie in rows, the highest first; and the size of all.
struct Packing {
    std::vector<glm::uvec2> corners;
    glm::uvec2 size{1};
};
Packing packed(const std::vector<EdgedLevel>& levels) {
    Packing out{std::vector<glm::uvec2>(levels.size()), {1, 1}};
    std::vector<size_t> order(levels.size());
    uint64_t texels = 0;
    for (size_t i = 0; i < levels.size(); ++i) {
        order[i] = i;
        texels += levels[i].pixels.size();
        out.size.x = std::max(out.size.x, levels[i].width);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return levels[a].height > levels[b].height; });
    out.size.x = std::max(out.size.x, std::bit_ceil(static_cast<uint32_t>(std::sqrt(double(texels)))));
    glm::uvec2 at(0);
    uint32_t row = 0;
    for (const size_t i : order) {
        if (at.x + levels[i].width > out.size.x)
            at = {0, at.y + row};
        row = at.x == 0 ? levels[i].height : row;
        out.corners[i] = at;
        at.x += levels[i].width;
        out.size.y = std::max(out.size.y, at.y + levels[i].height);
    }
    return out;
}

} // namespace

DistributionMaps::DistributionMaps(const Scene& scene, std::span<const PlacedLight> lights, uint32_t longest)
    : scene_(&scene) {
    std::vector<EdgedLevel> made;
    for (const PlacedLight& placed : lights) {
        const Light& light = placed.light;
        const auto first = static_cast<uint32_t>(made.size());
        if (light.profile && profiles_.try_emplace(light.profile.get()).second) {
            made.push_back(profile_level(*light.profile));
            profiles_[light.profile.get()] = {light.profile, first, made.back().width - 2, made.back().height - 2};
        }
        const CookieKind kind = cookie_kind(scene, light);
        if (kind == CookieKind::none || cookies_.contains({light.cookie, kind}))
            continue;
        const TextureImage& image = scene.images.at(light.cookie);
        const auto begin = static_cast<uint32_t>(made.size());
        for (EdgedLevel& level : cookie_levels(image, kind))
            made.push_back(std::move(level));
        const uint32_t faces = kind == CookieKind::cube ? 6 : 1;
        const double texels = kind == CookieKind::sphere ? image.height / pi
                              : kind == CookieKind::cube ? 0.5 * image.height
                                                         : 0.5 * std::max(image.width, image.height);
        cookies_[{light.cookie, kind}] = {begin, (static_cast<uint32_t>(made.size()) - begin) / faces - 1, texels};
    }
    if (made.empty())
        return;
    const Packing packing = packed(made);
    if (packing.size.x > longest || packing.size.y > longest)
        throw Error(
            fmt::format("{}: cookies and profiles of its lights need an image of {}x{}, and the device's limit is {}",
                        scene.name, packing.size.x, packing.size.y, longest));
    picture_ = Image(packing.size.x, packing.size.y);
    texel_ = 1.0 / glm::dvec2(packing.size);
    for (size_t i = 0; i < made.size(); ++i) {
        const EdgedLevel& level = made[i];
        const glm::uvec2 corner = packing.corners[i];
        for (uint32_t y = 0; y < level.height; ++y)
            std::copy_n(&level.pixels[size_t(y) * level.width], level.width,
                        &picture_.pixels[size_t(corner.y + y) * picture_.width + corner.x]);
        levels_.push_back({glm::vec4(corner.x + 1, corner.y + 1, level.width - 2, level.height - 2)});
    }
}

bool DistributionMaps::hold(const Light& light) const {
    return (light.cookie == no_cookie || cookies_.contains({light.cookie, cookie_kind(*scene_, light)})) &&
           (!light.profile || profiles_.contains(light.profile.get()));
}

shared::DistributionData DistributionMaps::record(const PlacedLight& placed) const {
    const Light& light = placed.light;
    const glm::dmat3 axes = light_axes(placed);
    shared::DistributionData out{};
    out.right = glm::vec4(axes[0], texel_.x);
    out.up = glm::vec4(axes[1], texel_.y);
    if (const CookieKind kind = cookie_kind(*scene_, light); kind != CookieKind::none) {
        const Cookie& cookie = cookies_.at({light.cookie, kind});
        const double scale = kind == CookieKind::spot ? 1 / std::tan(double(light.outer_cone)) : 1.0;
        out.cookie = glm::vec4(cookie_code(kind), cookie.first, cookie.last, scale);
        out.detail.x = static_cast<float>(cookie.texels * scale);
    }
    if (light.profile) {
        const Profile& profile = profiles_.at(light.profile.get());
        const glm::vec4 corner = levels_[profile.level].rectangle;
        const double first = light.profile->vertical.front() * pi / 180,
                     last = light.profile->vertical.back() * pi / 180;
        const double rows = (profile.rows - 1) / (last - first);
        // Texels are the profile's values at even steps: their centres.
        out.profile = glm::vec4(corner.x + 0.5, profile.columns / (2 * pi), corner.y + 0.5 - first * rows, rows);
        // The axis itself is lit, whatever rounding says; past the last angle it is dark.
        out.detail = glm::vec4(out.detail.x, 1, first <= 0 ? -1 : first, last >= pi ? 4 : last);
    }
    return out;
}

} // namespace prelight::resident
