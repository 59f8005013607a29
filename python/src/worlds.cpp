#include "boxes.hpp"
#include <prelight/framing.hpp>
#include <prelight/vary.hpp>

namespace prelight::python {
namespace {

template <auto Member>
auto world_entries(const std::shared_ptr<WorldBox>& box) {
    using T = typename std::decay_t<decltype(std::declval<World&>().*Member)>::value_type;
    return Entries<T>{
        box, [](void* owner, bool) -> std::vector<T>& { return static_cast<WorldBox*>(owner)->world.*Member; }};
}

void bind_instances(py::module_& module) {
    py::class_<Entry<Instance>> instance(module, "Instance", "An object of a world: a mesh at a place.");
    instance.def_property_readonly(
        "mesh", [](const Entry<Instance>& entry) { return entry.get().mesh; }, "Number of one of the scene's meshes.");
    instance.def_property_readonly(
        "node", [](const Entry<Instance>& entry) { return entry.get().node; }, "Number of one of the scene's nodes.");
    field(
        instance, "visible", [](auto& i) -> auto& { return i.visible; }, "False: not drawn, and casts no shadow.");
    instance.def_property(
        "transform", [](const Entry<Instance>& entry) { return from_matrix(entry.get().transform); },
        [](Entry<Instance>& entry, const ArrayLike& given) {
            const glm::dmat4 transform = to_affine(given, "transform");
            Instance& edited = entry.edit();
            edited.transform = transform;
            edited.mirrored = glm::determinant(glm::dmat3(transform)) < 0;
            edited.previous_transform.reset();
        },
        "(4, 4) float64, object to world, for column vectors: the last column is where it stands, metres.");
    instance.def("__repr__", [](const Entry<Instance>& entry) {
        const glm::dvec4 place = entry.get().transform[3];
        return py::str("Instance(mesh={}, node={}, position=({:.6g}, {:.6g}, {:.6g}))")
            .format(entry.get().mesh, entry.get().node, place.x, place.y, place.z);
    });
    bind_entries<Instance>(module, "InstanceList", "The objects of a world.");
}

void bind_light_changes(py::class_<WorldBox, std::shared_ptr<WorldBox>>& world) {
    world.def(
        "scatter_lights",
        [](WorldBox& box, uint32_t count, uint64_t seed) {
            if (count > (1u << 24))
                throw UsageError("scatter_lights: more than 16777216");
            scatter_lights(box.world, count, seed);
        },
        py::arg("count"), py::arg("seed") = 1,
        "Adds point lights, even over the bounds, with a range that puts about 8 of them on a point. The same seed "
        "gives "
        "the same lights.");
    world.def(
        "rotate_lights",
        [](WorldBox& box, const ArrayLike& centre, double angle) {
            if (!std::isfinite(angle))
                throw UsageError("angle: not finite");
            rotate_lights(box.world.lights, to_vector<glm::dvec3>(centre, "centre"), angle);
        },
        py::arg("centre"), py::arg("angle"),
        "Turns all lights around the vertical line through centre (world, metres) by angle, radians, counter-clockwise "
        "seen from above.");
    world.def(
        "randomize_lights", [](WorldBox& box, uint64_t seed) { randomize_lights(box.world.lights, seed); },
        py::arg("seed") = 1, "Gives each light another kind, colour, cone and range; positions stay.");
}

} // namespace

glm::dmat4 to_affine(const ArrayLike& given, const std::string& what) {
    const auto matrix = to_matrix<glm::dmat4>(given, what);
    for (int column = 0; column < 4; ++column)
        if (matrix[column][3] != (column == 3 ? 1 : 0))
            throw UsageError(what + ": the last row is not 0 0 0 1");
    return matrix;
}

World checked_copy(const WorldBox& box) {
    check_lights_given(*box.scene, box.world.lights);
    return box.world;
}

void bind_worlds(py::module_& module) {
    bind_instances(module);
    py::class_<WorldBox, std::shared_ptr<WorldBox>> world(
        module, "World",
        "What one picture shows: a scene's nodes in world space, metres. Scene.resolve() makes one. What is changed "
        "here "
        "shows after Renderer.set_world(); the scene, and other worlds of it, stay as they are.");
    world.def_property(
        "lights", &world_entries<&World::lights>,
        [](WorldBox& box, const py::object& lights) { box.world.lights = copies_of<PlacedLight>(lights); },
        "May be edited in place, or assigned any iterable of Light.");
    world.def_property(
        "cameras", &world_entries<&World::cameras>,
        [](WorldBox& box, const py::object& cameras) {
            box.world.cameras = copies_of<PlacedCamera>(cameras);
            box.world.framed = false;
        },
        "May be edited in place, or assigned any iterable of Camera. A scene without one gets one that sees all of "
        "it.");
    world.def_property_readonly("instances", &world_entries<&World::instances>,
                                "The objects, which may be moved and hidden.");
    world.def_property(
        "ambient", [](const WorldBox& box) { return from_vector(box.world.ambient); },
        [](WorldBox& box, const ArrayLike& given) {
            const auto ambient = to_vector<glm::vec3>(given, "ambient");
            if (glm::any(glm::lessThan(ambient, glm::vec3(0))))
                throw UsageError("ambient: below 0");
            box.world.ambient = ambient;
        },
        "(3,) float32: light from all around, linear RGB radiance. Without effect where the scene has an environment.");
    world.def_property_readonly(
        "bounds",
        [](const WorldBox& box) {
            py::array_t<double> bounds({2, 3});
            for (int i = 0; i < 3; ++i) {
                bounds.mutable_at(0, i) = box.world.bounds_min[i];
                bounds.mutable_at(1, i) = box.world.bounds_max[i];
            }
            return read_only(std::move(bounds));
        },
        "(2, 3) float64, world, metres: least and greatest coordinates of all triangles.");
    world.def_property_readonly(
        "triangles", [](const WorldBox& box) { return box.world.triangles; }, "How many.");
    world.def_property_readonly(
        "warnings", [](const WorldBox& box) { return warnings_of(box.world); },
        "What was repaired or left out, and what cannot be shown, one line each.");
    world.def(
        "frame",
        [](const WorldBox& box, double aspect, double azimuth, double elevation, double fit) {
            if (!(aspect > 0 && std::isfinite(aspect) && fit > 0 && std::isfinite(fit)))
                throw UsageError("frame: aspect and fit are numbers above 0");
            if (!(std::abs(elevation) <= 90 && std::isfinite(azimuth)))
                throw UsageError("frame: elevation is not in -90 ... 90, or azimuth not finite");
            return Entry<PlacedCamera>(frame(box.world, aspect, {azimuth, elevation, fit}));
        },
        py::arg("aspect"), py::arg("azimuth") = 20.0, py::arg("elevation") = 15.0, py::arg("fit") = 0.8,
        "The camera that sees all triangles. aspect: the picture's width / height; azimuth: degrees about +Y, 0 looks "
        "from "
        "+Z; elevation: degrees above the horizon; fit: how much of the picture they span.");
    bind_light_changes(world);
    world.def("__repr__", [](const WorldBox& box) {
        return py::str("World(of {!r}, instances={}, lights={}, cameras={}, triangles={})")
            .format(box.scene->name, box.world.instances.size(), box.world.lights.size(), box.world.cameras.size(),
                    box.world.triangles);
    });
}

} // namespace prelight::python
