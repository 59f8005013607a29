#include <future>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/city.hpp>
#include <scene/procedural/city_plan.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight {

Scene make_city(uint32_t lights, uint64_t seed) {
    city::Plan plan;
    plan.random = Random(seed);
    Scene& scene = plan.scene;
    scene.name = "city";
    scene.scenes = {{.name = "city", .nodes = {}}};
    scene.ambient = {0.016f, 0.023f, 0.046f}; // moonlight through cloud
    const auto camera = [&](const char* name, double yfov, glm::dvec3 eye, glm::dvec3 target) {
        add_camera(scene, {.name = name, .yfov = yfov}, eye, target);
    };
    camera("street", 0.82, {0.3, 3.0, 13.5}, {-0.1, 3.7, -20});
    camera("crossing", 0.95, {0.2, 1.8, -13.2}, {4.5, 3.8, -36});
    camera("above", 0.80, {5.0, 20, 17}, {-1.2, 0, -25});
    // The pictures take longer than all the rest, and nothing of the rest looks at them.
    std::future<std::vector<TextureImage>> pictures = std::async(std::launch::async, city::make_pictures);
    city::add_materials(scene);
    city::add_ground(plan);
    city::add_buildings(plan);
    city::add_signs(plan);
    city::add_cars(plan);
    city::add_props(plan);
    city::add_strings(plan);
    city::place_lights(plan, lights);
    scene.images = pictures.get();
    return std::move(plan.scene);
}

} // namespace prelight
