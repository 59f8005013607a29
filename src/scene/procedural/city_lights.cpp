#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/city_plan.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight::city {
namespace {

/// Where the eye rests: lights of a rank are given out from here.
constexpr glm::dvec3 focus(0, 2, -4);

/// A node whose −Z axis points along `direction`.
glm::dmat4 aimed(const glm::dvec3& position, const glm::dvec3& direction) {
    const glm::dvec3 up = std::abs(direction.y) > 0.9 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    const PlacedCamera placed = look_at({}, position, position + direction, up);
    glm::dmat4 local(placed.axes);
    local[3] = {position, 1};
    return local;
}

void add_site(Scene& scene, const Site& site) {
    const glm::dmat4 local =
        site.light.kind == LightKind::spot ? aimed(site.position, site.direction) : translation(site.position);
    add_root(scene, {}, local).light = append(scene.lights, site.light);
}

/// A random order that depends on nothing but the seed.
std::vector<uint32_t> shuffled(size_t count, Random& random) {
    std::vector<uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0u);
    for (size_t i = count; i > 1; --i)
        std::swap(order[i - 1], order[random.below(static_cast<uint32_t>(i))]);
    return order;
}

/// Small lights: their range falls with the root of their number, so that the sum of their areas,
/// and with it the number of lights on a point, stays the same; their intensity falls with the
/// range squared, so that each looks as bright in the middle of its smaller circle.
struct Small {
    float range, intensity;
    Small(size_t count, double area) {
        constexpr double overlap = 7, widest = 3; // lights on a point; metres
        range = static_cast<float>(
            std::min(widest, std::sqrt(overlap * area / (std::numbers::pi * static_cast<double>(count)))));
        intensity = 0.11f * range * range;
    }
};

/// A place in front of the walls and on the pavements, each square metre as likely as any other.
Site on_sheet(Plan& plan, const std::vector<double>& area_sums, const Small& small) {
    const double pick = plan.random.uniform(0, area_sums.back());
    const auto found = std::upper_bound(area_sums.begin(), area_sums.end() - 1, pick);
    const Sheet& sheet = plan.sheets[static_cast<size_t>(found - area_sums.begin())];
    const float s = plan.uniform(0, sheet.size.x), y = plan.uniform(0, sheet.size.y);
    const float d = small.range * plan.uniform(0.25f, 0.6f);
    // Broad fields of colour drift over the fronts.
    const glm::vec3 at = sheet.frame.point({s, y, d});
    const double hue = 0.08 + 0.10 * std::sin(0.11 * at.z + 0.21 * at.y) + (plan.chance(0.25) ? plan.random.unit() : 0);
    return {.light = {.colour = hue_colour(hue, plan.random.uniform(0.35, 0.85)),
                      .intensity = small.intensity,
                      .range = small.range},
            .position = at};
}

/// Takes from `first` and `second` in turn; the rest of the longer one follows.
std::vector<Site> in_turn(const std::vector<Site>& first, const std::vector<Site>& second) {
    std::vector<Site> sites;
    for (size_t i = 0; i < std::max(first.size(), second.size()); ++i) {
        if (i < first.size())
            sites.push_back(first[i]);
        if (i < second.size())
            sites.push_back(second[i]);
    }
    return sites;
}

/// `count` small lights: on bulbs in random order, and when these are used up on the sheets.
std::vector<Site> small_lights(Plan& plan, size_t count) {
    std::vector<Site> sites;
    const size_t hung = std::min(count, plan.bulbs.size());
    constexpr double bulb_area = 1.0; // square metres that a bulb has to light
    const Small bulb_light(hung, bulb_area * static_cast<double>(plan.bulbs.size()));
    const std::vector<uint32_t> order = shuffled(plan.bulbs.size(), plan.random);
    for (size_t i = 0; i < hung; ++i) {
        const Bulb& bulb = plan.bulbs[order[i]];
        sites.push_back({.light = {.colour = bulb.colour, .intensity = bulb_light.intensity, .range = bulb_light.range},
                         .position = bulb.position});
    }
    std::vector<double> area_sums;
    double area = 0;
    for (const Sheet& sheet : plan.sheets)
        area_sums.push_back(area += double(sheet.size.x) * double(sheet.size.y));
    const Small sheet_light(std::max<size_t>(count - hung, 1), area);
    while (sites.size() < count)
        sites.push_back(on_sheet(plan, area_sums, sheet_light));
    return sites;
}

} // namespace

void place_lights(Plan& plan, uint32_t count) {
    Scene& scene = plan.scene;
    scene.lights.reserve(count);
    scene.nodes.reserve(scene.nodes.size() + count);
    for (auto& sites : plan.sites)
        std::stable_sort(sites.begin(), sites.end(), [](const Site& a, const Site& b) {
            return glm::distance(a.position, focus) < glm::distance(b.position, focus);
        });
    const auto rank = [&](Rank r) -> const std::vector<Site>& { return plan.sites[static_cast<size_t>(r)]; };
    const auto place = [&](const std::vector<Site>& sites) {
        for (const Site& site : sites)
            if (scene.lights.size() < count)
                add_site(scene, site);
    };
    place(in_turn(rank(Rank::lamp), rank(Rank::head)));
    for (const Rank r : {Rank::neon, Rank::shop, Rank::tail})
        place(rank(r));
    // Windows and small lights share what is left, half and half while there are windows.
    const size_t left = count - scene.lights.size();
    const size_t windows = std::min(left / 2, rank(Rank::window).size());
    place(in_turn(small_lights(plan, left - windows), rank(Rank::window)));
}

} // namespace prelight::city
