// Where lights are evaluated for a pixel's samples: ReferenceSamples::Light.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <reference/pixel_shader.hpp>
#include <reference/visibility.hpp>

namespace prelight::reference {
namespace {

constexpr double any_colour = std::numeric_limits<double>::infinity();

using LightPlace = ReferenceSamples::Light;

bool before_camera(const Hit& hit) {
    return std::isfinite(glm::dot(hit.weights, hit.weights)) && std::isfinite(hit.distance) && hit.distance > 0;
}

/// Lights are evaluated there from now on.
void light_at(Surface& surface, const Ray& ray, double depth) {
    surface.position = ray.origin + ray.direction * depth;
    surface.view = glm::normalize(-ray.direction);
}

} // namespace

Shared PixelShader::share(const Sample& first, const Sample& other, const Likeness& likeness) const {
    const auto looks = [&](const Sample& one) {
        Looks looks{one.surface, one.hit.distance};
        if (form_.samples.colours_apart)
            looks.light = Lighting(form_, one.surface, factor_, world_.environment()).radiance(ambient_) * factor_;
        return looks;
    };
    return share_surface(looks(first), looks(other), world_.lens().pixel(first.hit.distance), likeness);
}

bool PixelShader::are_one_surface() {
    const Likeness likeness{0.99, 0.05, form_.samples.colours_apart ? 1.0 / 128 : any_colour};
    const std::span<Sample> all = samples();
    if (!std::all_of(all.begin(), all.end(), [](const Sample& one) { return one.found; }))
        return false;
    AllShared shared;
    for (const Sample& sample : all.subspan(1))
        shared.add(share(all[0], sample, likeness));
    all[0].unclear = !shared.sum().clear;
    return shared.sum().yes;
}

/// The pixel's one place (ReferenceSamples).
void PixelShader::choose_pixel() {
    const std::span<Sample> all = samples();
    one_surface_ = are_one_surface();
    const auto first = std::find_if(all.begin(), all.end(), [](const Sample& one) { return one.found; });
    if (first == all.end()) {
        pixel_ = all[0];
        return;
    }
    if (one_surface_)
        pixel_ = centre_of(*first);
    if (!one_surface_ || pixel_.runs_away) {
        pixel_ = *first;
        light_at(pixel_.surface, centre_ray_, first->hit.distance);
        pixel_.hit.position = pixel_.surface.position;
    } else if (several_triangles()) {
        light_at(pixel_.surface, centre_ray_, mean_depth([](const Sample&) { return true; }));
    }
    occlude(pixel_);
}

/// An edge pixel's surfaces, each at the mean place of its samples.
void PixelShader::choose_edges() {
    const Likeness likeness{0.9995, 0.01, form_.samples.colours_apart ? 0 : any_colour};
    const std::span<Sample> all = samples();
    for (uint32_t i = 0; i < all.size(); ++i) {
        edge_[i] = i;
        for (uint32_t before = 0; all[i].found && before < i && edge_[i] == i; ++before)
            if (all[before].found) {
                const Shared shared = share(all[before], all[i], likeness);
                all[i].unclear = all[i].unclear || !shared.clear;
                if (shared.yes)
                    edge_[i] = edge_[before];
            }
    }
    for (uint32_t i = 0; i < all.size(); ++i) {
        if (edge_[i] != i || !all[i].found)
            continue;
        edges_[i] = all[i];
        const auto here = [&](const Sample& one) { return edge_[static_cast<size_t>(&one - all.data())] == i; };
        const auto count = static_cast<double>(std::count_if(all.begin(), all.end(), here));
        glm::dvec2 place(0);
        for (const Sample& one : all)
            place += here(one) ? one.place / count : glm::dvec2(0);
        if (count > 1) {
            const Ray ray = world_.lens().ray(x_, y_, place);
            if (const Hit hit = world_.rays().beside(all[i].hit, ray); before_camera(hit))
                edges_[i].hit = hit; // shadow rays start on the surface: the mean may lie within it
            light_at(edges_[i].surface, ray, mean_depth(here));
        }
        occlude(edges_[i]);
    }
}

bool PixelShader::several_triangles() const {
    return std::any_of(samples_.begin(), samples_.begin() + form_.samples.count,
                       [](const Sample& one) { return one.owner != 0; });
}

/// Over a bent surface one shadow ray tells less of a pixel than one from each sample. And its place may lie within the
/// body, deeper than shadow maps are moved. At an edge it is the first sample's moved to the pixel's centre, maybe
/// beyond its surface, where no neighbour tells how near a shadow's border is.
void PixelShader::doubt_shadows() {
    if (one_surface_ && !several_triangles())
        return;
    std::array<Hit, most_samples + 6> starts;
    uint32_t count = 0;
    Sample* first = nullptr;
    for (Sample& sample : samples())
        if (sample.found && (!first || one_surface_)) {
            first = first ? first : &sample;
            starts[count++] = sample.hit;
        }
    const glm::dvec3 moved = pixel_.surface.position - pixel_.hit.position;
    if (!one_surface_) {
        starts[count++] = pixel_.hit;
        for (const glm::dvec2& aside : {glm::dvec2(0), glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(1)})
            if (const Hit hit = world_.rays().beside(first->hit, world_.lens().ray(x_, y_, aside)); before_camera(hit))
                starts[count++] = hit;
    } else if (std::abs(glm::dot(moved, pixel_.hit.geometric_normal)) > world_.lens().pixel(pixel_.hit.distance) / 32) {
        starts[count] = pixel_.hit;
        starts[count++].position = pixel_.surface.position;
    }
    uint64_t first_mask = 0;
    for (uint32_t i = 0; i < count; ++i) {
        Lighting lights(form_, pixel_.surface, factor_, world_.environment());
        const uint64_t mask = world_.gather(lights, pixel_.surface, starts[i], reached_);
        first_mask = i == 0 ? mask : first_mask;
        first->shadow_unclear = first->shadow_unclear || mask != first_mask;
    }
}

/// View depth where the device depth is the mean of some samples'.
template <class Which>
double PixelShader::mean_depth(const Which& which) const {
    const bool perspective = world_.lens().perspective();
    double sum = 0, count = 0;
    for (const Sample& one : std::span(samples_).first(form_.samples.count))
        if (which(one)) {
            sum += perspective ? 1 / one.hit.distance : one.hit.distance;
            ++count;
        }
    return perspective ? count / sum : sum / count;
}

/// Where lights are evaluated for a sample.
Sample& PixelShader::point_of(const Sample& sample) {
    const auto index = static_cast<uint32_t>(&sample - samples_.data());
    switch (form_.samples.light) {
    case LightPlace::sample: return samples_[index];
    case LightPlace::pixel: return pixel_;
    case LightPlace::edges: return one_surface_ ? pixel_ : edges_[edge_[index]];
    case LightPlace::fragment: break;
    }
    return centres_[sample.owner];
}

Sample PixelShader::centre_of(const Sample& owner) const {
    Sample centre = owner;
    centre.hit = world_.rays().beside(owner.hit, centre_ray_);
    centre.runs_away = !before_camera(centre.hit);
    if (centre.runs_away) {
        centre.hit = owner.hit;
    } else {
        centre.place = pixel_centre;
        centre.ray = centre_ray_;
    }
    centre.surface = world_.surface(centre.hit, x_, y_, centre.place);
    return centre;
}

/// What of light comes from around the point: what nearby surfaces leave of ambient light, and the lights of another
/// resolution.
void PixelShader::occlude(Sample& point, bool layer) const {
    if (inferred_) {
        const InferredLight::Found found = inferred_->at(x_, y_, point.hit, layer);
        point.inferred = found.sums;
        point.surface.visibility = found.visibility;
        point.light_unclear = found.doubtful;
        return;
    }
    if (form_.occlusion_radius > 0)
        point.surface.visibility =
            ray_visibility(world_.rays(), point.hit, point.surface.normal, form_.occlusion_radius);
}

} // namespace prelight::reference
