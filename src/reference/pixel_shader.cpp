#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <reference/pixel_shader.hpp>

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

/// What another point of its fragment was shaded as, or it itself, where the sample's ray meets it.
Sample shown_by(const Sample& place, const Sample& shaded) {
    Sample out = shaded;
    out.place = place.place;
    out.ray = place.ray;
    out.hit = place.hit;
    return out;
}

} // namespace

bool leave_shown(const SeenWorld& world, Sample::Shows shows, uint32_t x, uint32_t y, glm::dvec2 place, bool& found,
                 Hit& hit, std::vector<Hit>& layers) {
    if (shows == Sample::Shows::all)
        return false;
    constexpr double least_alpha = 1.0 / 16;
    const auto first =
        shows == Sample::Shows::opaque ? layers.end() : std::find_if(layers.begin(), layers.end(), [&](const Hit& one) {
            return world.surface(one, x, y, place).alpha >= least_alpha;
        });
    const bool layer = first != layers.end();
    if (layer) {
        const uint64_t masks = hit.mask_outcome;
        hit = *first;
        hit.mask_outcome = masks;
        found = true;
    }
    layers.clear();
    return layer;
}

std::span<const Sample> PixelShader::shade(uint32_t x, uint32_t y) {
    x_ = x;
    y_ = y;
    look(true);
    shade_surfaces();
    for (uint32_t i = 0; i < samples().size(); ++i)
        lay_over(i);
    lay_over_halves();
    return samples();
}

glm::dvec3 PixelShader::shade_opaque(uint32_t x, uint32_t y) {
    x_ = x;
    y_ = y;
    look(false);
    shade_surfaces();
    glm::dvec3 sum(0);
    for (const Sample& sample : samples())
        sum += glm::dvec3(sample.colour);
    return sum / static_cast<double>(samples().size());
}

void PixelShader::shade_surfaces() {
    const std::span<Sample> all = samples();
    for (uint32_t i = 0; i < all.size(); ++i)
        if (all[i].found)
            take_surfaces(i);
    const bool edges = form_.samples.light == LightPlace::edges;
    if (form_.samples.light == LightPlace::pixel || edges || form_.samples.shadows_per_pixel)
        choose_pixel();
    if (edges && !one_surface_)
        choose_edges();
    if (form_.shadows && (one_surface_ || (form_.samples.shadows_per_pixel && pixel_.found)))
        doubt_shadows();
    const bool per_fragment = at_fragments(form_.samples.material);
    for (uint32_t i = 0; i < all.size(); ++i) {
        Sample* targets[most_samples] = {&all[i]};
        if (!all[i].found) {
            all[i].colour = behind(all[i]);
        } else if (!per_fragment || all[i].layer) {
            shade_material(at_fragments(form_.samples.geometry) ? world_.surface(all[i].hit, x_, y_, all[i].place)
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
}

void PixelShader::look(bool at_layers) {
    centre_ray_ = world_.lens().ray(x_, y_, pixel_centre);
    const std::span<const glm::dvec2> places = sample_positions(form_.samples.count);
    for (uint32_t i = 0; i < places.size(); ++i) {
        Sample& sample = samples_[i] = {};
        centres_[i].runs_away = false;
        sample.place = places[i];
        sample.ray = world_.lens().ray(x_, y_, sample.place);
        sample.found = world_.rays().closest(sample.ray, sample.hit, at_layers ? &layers_[i] : nullptr);
        if (at_layers && form_.half_samples && !world_.rays().transmits()) {
            sample.shows = i == 1 || i == 2 ? Sample::Shows::nearest : Sample::Shows::opaque;
            sample.layer =
                leave_shown(world_, sample.shows, x_, y_, sample.place, sample.found, sample.hit, layers_[i]);
        }
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
    if (geometry_at_fragments && !masked && !sample.layer) { // the normal is stored once, depth for each sample
        sample.surface = centre.surface;
        sample.surface.position = sample.hit.position;
        sample.surface.view = glm::normalize(-sample.ray.direction);
    } else {
        sample.surface = world_.surface(sample.hit, x_, y_, sample.place);
    }
    if (light == LightPlace::sample)
        occlude(sample);
}

glm::vec3 PixelShader::behind(const Sample& sample) const {
    return glm::vec3(world_.background(at_fragments(form_.samples.material) ? centre_ray_ : sample.ray) * factor_);
}

/// Lights at some points of the pixel on one material there: their mean.
Lighting PixelShader::shine(const ReferenceForm& form, const Surface& material, std::span<const Point> points,
                            bool shadows_at_pixel) {
    Lighting lighting(form, material, factor_, world_.environment());
    for (const auto& [point, share] : points) {
        if (inferred_) {
            lighting.take(point->inferred, share);
            point->lit = true;
            continue;
        }
        const Surface lit = lit_as(material, point->surface);
        Lighting lights(form, lit, factor_, world_.environment());
        const bool at_pixel = shadows_at_pixel && pixel_.found && point != &pixel_;
        const ShadowPlace pixel{pixel_.hit, pixel_.surface.normal};
        point->shadow_mask = world_.gather(lights, lit, point->hit, reached_, at_pixel ? &pixel : nullptr);
        point->lit = true;
        lighting.take(lights, share);
        if (at_pixel && !one_surface_) { // what neighbours of the same surface are compared with is its own
            Lighting own(form, lit, factor_, world_.environment());
            point->shadow_mask = world_.gather(own, lit, point->hit, reached_);
        }
    }
    return lighting;
}

/// The colour of some samples from one evaluation of their material. `owner`: of their triangle.
void PixelShader::shade_material(const Surface& material, uint32_t owner, std::span<Sample*> targets) {
    std::array<Point, most_samples> all_points{};
    size_t count = 0;
    for (const Sample* target : targets) {
        Sample* const point = &point_of(*target);
        size_t at = 0;
        while (at < count && all_points[at].sample != point)
            ++at;
        count = std::max(count, at + 1);
        all_points[at].sample = point;
        all_points[at].share += 1.0 / static_cast<double>(targets.size());
    }
    const bool dark = material.unlit || !all_points[0].sample->found;
    const auto points = std::span<const Point>(all_points).first(dark ? 0 : count);

    Surface seen = material;
    if (form_.occlusion_radius > 0 && !dark) {
        seen.visibility = 0;
        for (const auto& [point, share] : points)
            seen.visibility += share * point->surface.visibility;
    }
    Lighting lighting = shine(form_, seen, points, form_.samples.shadows_per_pixel);
    const LightSums sums = lighting.sums();
    const auto colour = glm::vec3(lighting.radiance(ambient_) * factor_);
    for (Sample* target : targets) {
        const Sample& point = point_of(*target);
        target->colour = colour;
        target->base_colour = material.base_colour;
        target->alpha = material.alpha;
        target->sums = sums;
        target->runs_away = centres_[owner].runs_away;
        target->lit = point.lit;
        target->shadow_mask = point.shadow_mask;
    }
}

/// Puts the blended surfaces in front of a sample over its colour.
void PixelShader::lay_over(uint32_t index) {
    if (layers_[index].empty())
        return;
    Sample& sample = samples_[index];
    const double behind = sample.found ? sample.hit.distance : std::numeric_limits<double>::infinity();
    glm::dvec3 sum(0);
    double through = 1;
    for (const Hit& hit : layers_[index]) {
        Sample& layer = sample.layers.emplace_back(layer_at(index, hit));
        if (const Draw& draw = world_.rays().draw(hit.draw); draw.material->softness > 0 && !draw.transmissive)
            layer.surface.alpha *=
                std::clamp((behind - hit.distance) / static_cast<double>(draw.material->softness), 0.0, 1.0);
        sum += through * layer.surface.alpha * glm::dvec3(layer.colour);
        through *= 1 - layer.surface.alpha;
        if (world_.rays().draw(hit.draw).transmissive) { // over the picture, whatever else is behind it
            sum += through * behind_->at(glm::dvec2(x_, y_) + pixel_centre, 0);
            through = 0;
        }
    }
    sample.colour = glm::vec3(sum + through * glm::dvec3(sample.colour));
}

/// [ReferenceForm::half_samples] The upper half of the pixel has samples 0 and 1, the lower one 2 and 3.
void PixelShader::lay_over_halves() {
    for (const auto& [layer, opaque] : {std::pair(1, 0), std::pair(2, 3)}) {
        const Sample& over = samples_[layer];
        if (!over.layer)
            continue;
        const auto mixed =
            glm::vec3(over.alpha * glm::dvec3(over.colour) + (1 - over.alpha) * glm::dvec3(samples_[opaque].colour));
        samples_[layer].colour = samples_[opaque].colour = mixed;
    }
}

/// A blended surface in front of a sample, shaded.
Sample PixelShader::layer_at(uint32_t index, const Hit& hit) {
    const bool soft = world_.rays().draw(hit.draw).material->softness > 0; // looks at each sample's depth
    const bool per_fragment = at_fragments(form_.samples.layers) && !soft;
    Sample layer;
    layer.place = samples_[index].place;
    layer.ray = samples_[index].ray;
    layer.hit = hit;
    layer.found = true;
    for (uint32_t before = 0; per_fragment && before < index; ++before)
        for (const Sample& other : samples_[before].layers)
            if (other.hit.draw == hit.draw && other.hit.triangle == hit.triangle)
                return shown_by(layer, other);
    Sample shaded = per_fragment ? centre_of(layer) : layer;
    if (!per_fragment)
        shaded.surface = world_.surface(hit, x_, y_, layer.place);
    occlude(shaded, true);
    if (const Draw& draw = world_.rays().draw(hit.draw); draw.transmissive) {
        const LookBehind look = look_behind(shaded.surface, world_.lens(), glm::dvec2(x_, y_) + shaded.place);
        shaded.surface.layers.behind = transmittance(shaded.surface) * behind_->at(look.place, look.level) / factor_;
        if (draw.material->alpha_mode != AlphaMode::blend)
            shaded.surface.alpha = 1;
    }
    const Point point{&shaded, 1};
    Lighting lighting = shine(layer_form_, shaded.surface, {&point, shaded.surface.unlit ? size_t(0) : 1}, false);
    shaded.colour = glm::vec3(lighting.radiance(ambient_) * factor_);
    return shown_by(layer, shaded);
}

} // namespace prelight::reference
