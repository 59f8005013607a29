#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <reference/pixel_shader.hpp>
#include <reference/visibility.hpp>

namespace prelight::reference {
namespace {

using LightPlace = ReferenceSamples::Light;

/// A material where it is, under light that another point of its pixel gets.
Surface lit_as(const Surface& material, const Surface& point) {
    Surface lit = material;
    lit.position = point.position;
    lit.normal = point.normal;
    lit.view = point.view;
    lit.roughness = point.roughness;
    return lit;
}

} // namespace

std::span<const Sample> PixelShader::shade(uint32_t x, uint32_t y) {
    x_ = x;
    y_ = y;
    look();
    const std::span<Sample> all = samples();
    for (uint32_t i = 0; i < all.size(); ++i)
        if (all[i].found)
            take_surfaces(i);
    if (form_.samples.light == LightPlace::pixel || form_.samples.shadows_per_pixel)
        choose_pixel();
    const bool per_fragment = at_fragments(form_.samples.material);
    for (uint32_t i = 0; i < all.size(); ++i) {
        Sample* targets[most_samples] = {&all[i]};
        if (!all[i].found) {
            all[i].colour = behind(all[i]);
        } else if (!per_fragment) {
            shade_material(at_fragments(form_.samples.geometry) ? world_.surface(all[i].hit, x, y, all[i].place)
                                                                : all[i].surface,
                           all[i].owner, {targets, 1});
        } else if (all[i].owner == i) {
            size_t owned = 0;
            for (Sample& sample : all)
                if (sample.found && sample.owner == i)
                    targets[owned++] = &sample;
            shade_material(centres_[i].surface, i, {targets, owned});
        }
    }
    return all;
}

void PixelShader::look() {
    centre_ray_ = world_.lens().ray(x_, y_, pixel_centre);
    const std::span<const glm::dvec2> places = sample_positions(form_.samples.count);
    for (uint32_t i = 0; i < places.size(); ++i) {
        Sample& sample = samples_[i] = {};
        centres_[i].runs_away = false;
        sample.place = places[i];
        sample.ray = world_.lens().ray(x_, y_, sample.place);
        sample.found = world_.rays().closest(sample.ray, sample.hit);
        sample.owner = i;
        for (uint32_t before = i; sample.found && before-- > 0;)
            if (samples_[before].found && samples_[before].hit.draw == sample.hit.draw &&
                samples_[before].hit.triangle == sample.hit.triangle)
                sample.owner = samples_[before].owner;
    }
}

/// What is needed of the sample's surface, and of its fragment's where it is the first of one.
void PixelShader::take_surfaces(uint32_t index) {
    const LightPlace light = form_.samples.light;
    const bool geometry_at_fragments = at_fragments(form_.samples.geometry);
    Sample& sample = samples_[index];
    Sample& centre = centres_[sample.owner];
    if (sample.owner == index &&
        (geometry_at_fragments || at_fragments(form_.samples.material) || light == LightPlace::fragment)) {
        centre = centre_of(sample);
        if (light == LightPlace::fragment)
            occlude(centre);
    }
    const bool masked = world_.rays().draw(sample.hit.draw).material->alpha_mode == AlphaMode::mask;
    if (geometry_at_fragments && !masked) { // the normal is stored once, depth for each sample
        sample.surface = centre.surface;
        sample.surface.position = sample.hit.position;
        sample.surface.view = glm::normalize(-sample.ray.direction);
    } else {
        sample.surface = world_.surface(sample.hit, x_, y_, sample.place);
    }
    if (light == LightPlace::sample)
        occlude(sample);
}

bool PixelShader::share_surface() const {
    const std::span<const Sample> all(samples_.data(), form_.samples.count);
    const Surface& first = all[0].surface;
    const double nv = std::max(std::abs(glm::dot(first.normal, first.view)), 1e-9);
    const double slope = std::min(std::sqrt(std::max(1 - nv * nv, 0.0)) / nv, 10.0);
    const double most = world_.lens().pixel(all[0].hit.distance) * (1 + 2 * slope);
    return std::all_of(all.begin(), all.end(), [&](const Sample& one) {
        return one.found && std::abs(one.hit.distance - all[0].hit.distance) <= most &&
               glm::dot(one.surface.normal, first.normal) >= 0.99 &&
               std::abs(one.surface.roughness - first.roughness) <= 0.05 * first.roughness;
    });
}

/// The pixel's one place (ReferenceSamples).
void PixelShader::choose_pixel() {
    const std::span<Sample> all = samples();
    const auto first = std::find_if(all.begin(), all.end(), [](const Sample& one) { return one.found; });
    if (first == all.end()) {
        pixel_ = all[0];
        return;
    }
    if (share_surface())
        pixel_ = centre_of(*first);
    if (!share_surface() || pixel_.runs_away) {
        pixel_ = *first;
        pixel_.hit.position = centre_ray_.origin + centre_ray_.direction * first->hit.distance;
        pixel_.surface.position = pixel_.hit.position;
        pixel_.surface.view = glm::normalize(-centre_ray_.direction);
    }
    occlude(pixel_);
}

Sample PixelShader::centre_of(const Sample& owner) const {
    Sample centre = owner;
    centre.hit = world_.rays().beside(owner.hit, centre_ray_);
    centre.runs_away = !std::isfinite(glm::dot(centre.hit.weights, centre.hit.weights)) ||
                       !std::isfinite(centre.hit.distance) || centre.hit.distance <= 0;
    if (centre.runs_away) {
        centre.hit = owner.hit;
    } else {
        centre.place = pixel_centre;
        centre.ray = centre_ray_;
    }
    centre.surface = world_.surface(centre.hit, x_, y_, centre.place);
    return centre;
}

void PixelShader::occlude(Sample& point) const {
    if (form_.occlusion_radius > 0)
        point.surface.visibility =
            ray_visibility(world_.rays(), point.hit, point.surface.normal, form_.occlusion_radius);
}

glm::vec3 PixelShader::behind(const Sample& sample) const {
    return glm::vec3(world_.background(at_fragments(form_.samples.material) ? centre_ray_ : sample.ray) * factor_);
}

/// The colour of some samples from one evaluation of their material. `owner`: of their triangle.
void PixelShader::shade_material(const Surface& material, uint32_t owner, std::span<Sample*> targets) {
    Sample* const one = form_.samples.light == LightPlace::pixel ? &pixel_ : &centres_[owner];
    const std::span<Sample* const> points =
        form_.samples.light == LightPlace::sample ? std::span<Sample* const>(targets) : std::span(&one, 1);
    const double share = 1.0 / static_cast<double>(points.size());
    const bool dark = material.unlit || !points[0]->found;

    Surface seen = material;
    if (form_.occlusion_radius > 0 && !dark) {
        seen.visibility = 0;
        for (const Sample* point : points)
            seen.visibility += share * point->surface.visibility;
    }
    Lighting lighting(form_, seen, factor_, world_.environment());
    if (!dark)
        for (Sample* point : points) {
            const Surface lit = lit_as(seen, point->surface);
            Lighting lights(form_, lit, factor_, world_.environment());
            const Hit* shadows_at = !form_.samples.shadows_per_pixel ? &point->hit
                                    : pixel_.found                   ? &pixel_.hit
                                                                     : nullptr;
            point->shadow_mask = world_.gather(lights, lit, point->hit, shadows_at, reached_);
            point->lit = true;
            lighting.take(lights, share);
        }
    const LightSums sums = lighting.sums();
    const auto colour = glm::vec3(lighting.radiance(ambient_) * factor_);
    for (Sample* target : targets) {
        target->colour = colour;
        target->base_colour = material.base_colour;
        target->sums = sums;
        target->runs_away = centres_[owner].runs_away;
        if (form_.samples.light != LightPlace::sample) {
            target->lit = one->lit;
            target->shadow_mask = one->shadow_mask;
        }
    }
}

} // namespace prelight::reference
