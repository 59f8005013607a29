#pragma once
#include <optional>
#include <reference/decals.hpp>
#include <reference/lens.hpp>
#include <reference/light_tree.hpp>
#include <reference/lighting.hpp>

namespace prelight::reference {

/// Where shadows are looked for in another one's place.
struct ShadowPlace {
    const Hit& hit;
    glm::dvec3 normal; ///< shading normal: lights that it turns away from have no shadow there
};

/// A world as one camera sees it: what a ray hits, what the surface there is like, which lights reach it. Positions are
/// relative to the camera.
class SeenWorld {
public:
    /// `aspect`: as Lens has it.
    SeenWorld(const World& world, const PlacedCamera& camera, uint32_t width, uint32_t height,
              const ReferenceForm& form, double aspect = 0);

    const Lens& lens() const { return lens_; }
    const RayScene& rays() const { return rays_; }
    const EnvironmentLight* environment() const { return environment_.there() ? &environment_ : nullptr; }
    /// Radiance where nothing is hit.
    glm::dvec3 background(const Ray& ray) const;
    /// The material at a hit of the ray through this place of the pixel, decals on it. Filters look along rays through
    /// the same place of the pixels beside it in its quad.
    Surface surface(const Hit& hit, uint32_t x, uint32_t y, glm::dvec2 place) const;
    /// Its normal alone, without decals.
    glm::dvec3 normal(const Hit& hit, const Ray& ray) const;
    /// Adds every light that reaches the surface and is not in shadow there. Returns a hash of those that are, or in
    /// part.
    /// Shadow rays start at `hit`, or `elsewhere` for lights that reach that place. `reached`: room to work in.
    uint64_t gather(Lighting& lighting, const Surface& surface, const Hit& hit, std::vector<uint32_t>& reached,
                    const ShadowPlace* elsewhere = nullptr) const;

private:
    Passage from_light(const Hit& hit, const Incident& light) const;
    Passage from_light(const Hit& hit, const Incident& light, const ShadowPlace& elsewhere, uint32_t index) const;

    const ReferenceForm& form_;
    const World& world_;
    Textures textures_;
    RayScene rays_;
    std::optional<Decals> decals_; ///< absent: the world has none
    LightTree lights_;
    EnvironmentLight environment_;
    Lens lens_;
};

} // namespace prelight::reference
