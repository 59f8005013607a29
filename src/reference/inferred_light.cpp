#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <parallel/parallel_for.hpp>
#include <reference/inferred_light.hpp>
#include <reference/visibility.hpp>

namespace prelight::reference {
namespace {

/// With less of the four shares a surface counts as missing.
constexpr double least_share = 1e-3;
/// How near a limit a figure may come, as a share of it, before single precision may take it over.
constexpr double close_call = 0.02;

uint32_t scaled(uint32_t pixels, double scale) { return static_cast<uint32_t>(std::ceil(pixels * scale)); }

} // namespace

InferredLight::InferredLight(const World& world, const PlacedCamera& camera, uint32_t width, uint32_t height,
                             const ReferenceForm& form, double factor)
    : frame_width_(width), frame_height_(height), width_(scaled(width, form.inferred_scale)),
      height_(scaled(height, form.inferred_scale)), form_(form), factor_(factor),
      world_(world, camera, width_, height_, form, double(width) / height), texels_(size_t(width_) * height_) {
    number_groups();
    choose_slots(world);
}

double InferredLight::closeness(double depth) const { return world_.lens().perspective() ? 1 / depth : -depth; }

double InferredLight::plane_at(const Hit& hit, glm::dvec2 place) const {
    return closeness(world_.rays().beside(hit, world_.lens().ray(0, 0, place + 0.5)).distance);
}

uint32_t InferredLight::group_of(const Hit& hit) const {
    const Primitive* primitive = world_.rays().draw(hit.draw).primitive;
    return groups_.at(primitive)[primitive->indices[size_t(hit.triangle) * 3]];
}

/// What the texel shows: its own layer, or what is opaque.
InferredLight::Seen InferredLight::look(uint32_t x, uint32_t y, glm::dvec2 place) const {
    Seen seen;
    std::vector<Hit> layers;
    seen.found = world_.rays().closest(world_.lens().ray(x, y, place), seen.opaque, &layers);
    seen.hit = seen.opaque;
    const uint32_t slot = x % 2 + 2 * (y % 2);
    for (const Hit& one : layers)
        if (slot > 0 && slots_[one.draw] == slot) {
            seen.hit = one;
            seen.found = seen.layer = true;
            break;
        }
    return seen;
}

void InferredLight::light_row(uint32_t y) {
    std::vector<uint32_t> reached;
    for (uint32_t x = 0; x < width_; ++x) {
        Texel& texel = texels_[size_t(y) * width_ + x];
        const Seen seen = look(x, y, pixel_centre);
        if (seen.found) {
            texel.draw = seen.hit.draw + 1;
            texel.group = group_of(seen.hit);
            texel.closeness = closeness(seen.hit.distance);
            const Surface surface = world_.surface(seen.hit, x, y, pixel_centre);
            Lighting lighting(form_, surface, factor_, world_.environment());
            texel.shadow_mask = world_.gather(lighting, surface, seen.hit, reached);
            texel.sums = lighting.sums();
            if (form_.occlusion_radius > 0 && !seen.layer)
                texel.visibility = ray_visibility(world_.rays(), seen.hit, surface.normal, form_.occlusion_radius);
        }
        constexpr double beside = 1.0 / 64;
        for (const glm::dvec2& off : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(-1, 1), glm::dvec2(1, 1)}) {
            const Seen other = look(x, y, pixel_centre + off * beside);
            texel.doubtful = texel.doubtful || other.found != seen.found ||
                             (seen.found && (other.hit.draw + 1 != texel.draw || group_of(other.hit) != texel.group));
        }
    }
}

void InferredLight::find_doubts() {
    const std::vector<Texel>& all = texels_;
    std::vector<uint8_t> doubtful(all.size());
    for (uint32_t y = 0; y < height_; ++y)
        for (uint32_t x = 0; x < width_; ++x) {
            const Texel& own = all[size_t(y) * width_ + x];
            bool differs = own.doubtful;
            for (uint32_t v = y - std::min(y, 2u); v <= std::min(y + 2, height_ - 1); ++v)
                for (uint32_t u = x - std::min(x, 2u); u <= std::min(x + 2, width_ - 1); ++u) {
                    const Texel& other = all[size_t(v) * width_ + u];
                    differs = differs || (other.draw == own.draw && other.shadow_mask != own.shadow_mask);
                }
            doubtful[size_t(y) * width_ + x] = differs;
        }
    for (size_t i = 0; i < texels_.size(); ++i)
        texels_[i].doubtful = doubtful[i] != 0;
}

/// Of the nine texels around a place, the one that shows the hit's object and is nearest to it, in widths of a texel.
bool InferredLight::find_nearest(glm::dvec2 place, const Hit& hit, double width, glm::ivec2& nearest,
                                 bool& doubtful) const {
    const glm::ivec2 middle(glm::floor(place + 0.5)), last(width_ - 1, height_ - 1);
    const double own = closeness(hit.distance);
    double least = std::numeric_limits<double>::infinity(), second = least;
    int number = 0;
    for (int v = -1; v <= 1; ++v)
        for (int u = -1; u <= 1; ++u, ++number) {
            const glm::ivec2 at = glm::clamp(middle + glm::ivec2(u, v), glm::ivec2(0), last);
            doubtful = doubtful || texel(at).doubtful;
            if (texel(at).draw != hit.draw + 1)
                continue;
            const glm::dvec2 away = glm::dvec2(at) - place;
            const double score =
                std::abs(texel(at).closeness - own) / width + away.x * away.x + away.y * away.y + 0.01 * number;
            if (score < least) {
                second = least;
                least = score;
                nearest = at;
            } else {
                second = std::min(second, score);
            }
        }
    doubtful = doubtful || second - least < 0.003;
    return std::isfinite(least);
}

InferredLight::Found InferredLight::at(uint32_t x, uint32_t y, const Hit& hit, bool layer) const {
    const glm::dvec2 ratio(double(width_) / frame_width_, double(height_) / frame_height_);
    const glm::dvec2 place = (glm::dvec2(x, y) + 0.5) * ratio - 0.5;
    const uint32_t slot = layer ? slots_[hit.draw] : 0;
    const int apart = layer ? 2 : 1;
    const glm::ivec2 first(slot % 2, slot / 2), last(width_ - 1, height_ - 1);
    const glm::dvec2 steps = (place - glm::dvec2(first)) / double(apart), low = glm::floor(steps), share = steps - low;

    const double own = closeness(hit.distance);
    const double width =
        world_.lens().pixel(hit.distance) * (world_.lens().perspective() ? 1 / (hit.distance * hit.distance) : 1.0);
    const double slope = std::abs(plane_at(hit, place + glm::dvec2(1, 0)) - own) +
                         std::abs(plane_at(hit, place + glm::dvec2(0, 1)) - own);
    const double most = apart * (slope / 2 + width);

    Found found;
    std::array<Tap, 4> taps;
    std::array<bool, 4> counts{};
    double total = 0;
    for (int i = 0; i < 4; ++i) {
        const glm::ivec2 corner(i % 2, i / 2);
        const glm::ivec2 room = glm::max((last - first) / apart, glm::ivec2(0));
        taps[i].at = glm::min(first + apart * glm::clamp(glm::ivec2(low) + corner, glm::ivec2(0), room), last);
        taps[i].share = (corner.x ? share.x : 1 - share.x) * (corner.y ? share.y : 1 - share.y);
        const Texel& one = texel(taps[i].at);
        const bool same = one.draw == hit.draw + 1 && one.group == group_of(hit);
        const double off = std::abs(one.closeness - plane_at(hit, taps[i].at));
        counts[i] = same && off <= most;
        total += counts[i] ? taps[i].share : 0;
        const bool close = same && std::abs(off - most) < close_call * most;
        found.doubtful = found.doubtful || (taps[i].share > least_share / 2 && (one.doubtful || close));
    }
    found.doubtful = found.doubtful || std::abs(total - least_share) < close_call * least_share;
    found.unmatched = total < least_share;
    glm::ivec2 nearest(0);
    if (!found.unmatched)
        for (int i = 0; i < 4; ++i)
            taps[i].share = counts[i] ? taps[i].share / total : 0;
    else if (find_nearest(place, hit, width, nearest, found.doubtful))
        taps = {Tap{nearest, 1}};
    found.visibility = layer ? 1 : 0;
    for (const Tap& tap : taps) {
        const Texel& one = texel(tap.at);
        found.sums.add(one.sums, tap.share);
        if (!layer)
            found.visibility += tap.share * one.visibility;
    }
    return found;
}

} // namespace prelight::reference
