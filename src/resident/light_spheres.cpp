// Compiled with -O3 (src/CMakeLists.txt): loops over plain numbers, without branches, so that the compiler takes
// several lights at once.
#include "light_spheres.hpp"
#include "wide.hpp"

namespace prelight::resident {

void LightSpheres::assign(std::span<const PlacedLight> lights) {
    for (std::vector<double>* list : {&x, &y, &z, &radius})
        list->resize(lights.size());
    for (size_t i = 0; i < lights.size(); ++i) {
        const Light& light = lights[i].light;
        const bool dark = light.intensity <= 0 || (light.colour.x <= 0 && light.colour.y <= 0 && light.colour.z <= 0);
        x[i] = lights[i].position.x;
        y[i] = lights[i].position.y;
        z[i] = lights[i].position.z;
        radius[i] = dark ? -endless : has_volume(light) ? double(light.range) : endless;
    }
}

namespace {

// Here, for the clones of a function with a name of its own are symbols of the library.
PRELIGHT_WIDE void test_batch(const LightSpheres& spheres, size_t first, size_t count, const glm::dvec3& eye,
                              const SphereView& view, SphereBatch& out) {
    const double* const xs = spheres.x.data() + first;
    const double* const ys = spheres.y.data() + first;
    const double* const zs = spheres.z.data() + first;
    const double* const radius = spheres.radius.data() + first;
    double x[sphere_batch], y[sphere_batch], z[sphere_batch], least[sphere_batch];
    for (size_t i = 0; i < count; ++i) {
        x[i] = xs[i] - eye.x;
        y[i] = ys[i] - eye.y;
        z[i] = zs[i] - eye.z;
        least[i] = 0; // of what is dark, -radius is more
    }
    for (size_t p = 0; p < view.plane_count; ++p) {
        const double px = view.planes[p].x, py = view.planes[p].y, pz = view.planes[p].z, pw = view.planes[p].w;
        for (size_t i = 0; i < count; ++i) {
            const double distance = px * x[i] + py * y[i] + pz * z[i] + pw;
            least[i] = distance < least[i] ? distance : least[i];
        }
    }
    for (size_t i = 0; i < count; ++i)
        out.shows[i] = least[i] < -radius[i] ? 0 : 1;
    const double fx = view.forward.x, fy = view.forward.y, fz = view.forward.z;
    for (size_t i = 0; i < count; ++i) {
        const double r = radius[i], depth = x[i] * fx + y[i] * fy + z[i] * fz;
        const double distance2 = view.perspective ? depth * depth - r * r : 1;
        const double share = 0.785 * r * r / (view.across * distance2);
        const bool inside = view.perspective & (depth <= r);
        out.share[i] = (inside | (share > 1)) ? 1 : share;
    }
}

} // namespace

void test_spheres(const LightSpheres& spheres, size_t first, size_t count, const glm::dvec3& eye,
                  const SphereView& view, SphereBatch& out) {
    test_batch(spheres, first, count, eye, view, out);
}

} // namespace prelight::resident
