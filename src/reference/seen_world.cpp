#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <reference/passed_surfaces.hpp>
#include <reference/seen_world.hpp>
#include <scene/takes_decals.hpp>

namespace prelight::reference {

SeenWorld::SeenWorld(const World& world, const PlacedCamera& camera, uint32_t width, uint32_t height,
                     const ReferenceForm& form, double aspect)
    : form_(form), world_(world), textures_(*world.scene, form.bilinear_level0),
      rays_(world, camera.position, textures_, form.transparency, form.transparent_shadows, camera.axes),
      lights_(world, camera.position), environment_(world.scene->environment.get()),
      lens_(camera, width, height, aspect) {
    if (!world.decals.empty())
        decals_.emplace(world, camera.position, textures_);
}

glm::dvec3 SeenWorld::background(const Ray& ray) const {
    return environment_.is_background() ? environment_.background(glm::normalize(ray.direction)) : glm::dvec3(0);
}

Surface SeenWorld::surface(const Hit& hit, uint32_t x, uint32_t y, glm::dvec2 place) const {
    const Ray ray = lens_.ray(x, y, place), across = lens_.ray(x ^ 1, y, place), down = lens_.ray(x, y ^ 1, place);
    std::optional<Beside> beside;
    if (!form_.bilinear_level0)
        beside = Beside{rays_.beside(hit, across), rays_.beside(hit, down)};
    Surface surface =
        evaluate_surface(rays_, textures_, hit, glm::normalize(-ray.direction), beside ? &*beside : nullptr);
    const auto normal_beside = [&](const Ray& other) { return normal(rays_.beside(hit, other), other); };
    const double spread = form_.specular_antialiasing && !surface.unlit
                              ? normal_spread(surface.normal, normal_beside(across), normal_beside(down))
                              : 0; // of the surface itself
    const Draw& draw = rays_.draw(hit.draw);
    if (decals_ && world_.instances[draw.instance].receives_decals && takes_decals(*draw.material))
        decals_->cover(surface);
    set_lamp_roughness(surface, spread);
    return surface;
}

glm::dvec3 SeenWorld::normal(const Hit& hit, const Ray& ray) const {
    return shading_normal(rays_, textures_, hit, glm::normalize(-ray.direction));
}

uint64_t SeenWorld::gather(Lighting& lighting, const Surface& surface, const Hit& hit, std::vector<uint32_t>& reached,
                           const ShadowPlace* elsewhere) const {
    const double pixel = lens_.pixel(hit.distance) / std::max(std::abs(glm::dot(surface.normal, surface.view)), 0.1);
    uint64_t shadow_mask = 0;
    lights_.reach(surface.position, reached);
    for (const uint32_t index : reached) {
        Incident light = lights_.incident(index, surface.position, pixel);
        if (!lighting.is_lit_by(light))
            continue;
        if (form_.shadows && light.casts_shadow) {
            const Passage passage = elsewhere ? from_light(hit, light, *elsewhere, index) : from_light(hit, light);
            const uint64_t mark = (index + uint64_t(1)) * 0x9e3779b97f4a7c15u;
            if (passage.crossed != 0) // which surfaces dim it: their alpha may well vary from pixel to pixel
                shadow_mask += scattered(mark ^ passage.crossed);
            else if (passage.transmittance == 0)
                shadow_mask += mark;
            light.radiance *= passage.transmittance;
        }
        lighting.add(light);
    }
    return shadow_mask;
}

Passage SeenWorld::from_light(const Hit& hit, const Incident& light, const ShadowPlace& elsewhere,
                              uint32_t index) const {
    const Incident there = lights_.incident(index, elsewhere.hit.position);
    const bool reaches = there.radiance != glm::dvec3(0) && glm::dot(elsewhere.normal, there.to_light) > 0;
    return reaches ? from_light(elsewhere.hit, there) : from_light(hit, light);
}

Passage SeenWorld::from_light(const Hit& hit, const Incident& light) const {
    const glm::dvec3 start = hit.position + hit.geometric_normal * hit.offset;
    return rays_.passage({start, light.to_light, 0, light.distance - hit.offset});
}

} // namespace prelight::reference
