#include "meshes.hpp"
#include <glm/gtc/matrix_transform.hpp>
#include <prelight/light_distribution.hpp>
#include <prelight/material_shader.hpp>
#include <prelight/scene_io.hpp>
#include <pybind11/stl/filesystem.h>

namespace prelight::python {
namespace {

using Path = std::filesystem::path;
using Box = std::shared_ptr<SceneBox>;

Box boxed(Scene scene) {
    auto box = std::make_shared<SceneBox>();
    *box->scene = std::move(scene);
    return box;
}

template <auto Member>
auto scene_entries(const Box& box) {
    using T = typename std::decay_t<decltype(std::declval<Scene&>().*Member)>::value_type;
    return Entries<T>{box, [](void* owner, bool edit) -> std::vector<T>& {
                          auto& scene = *static_cast<SceneBox*>(owner);
                          return (edit ? scene.edit() : *scene.scene).*Member;
                      }};
}

std::string name_or_number(const py::object& given, const char* what) {
    if (!py::isinstance<py::str>(given) && !py::isinstance<py::int_>(given))
        throw py::type_error(std::string(what) + ": a name or a number is needed, not " + shape_of(given));
    return py::str(given).cast<std::string>();
}

WorldBox resolved(const Box& box, const py::object& scene_name, std::optional<double> time, double interval,
                  const py::object& animation_name) {
    const std::shared_ptr<const Scene> scene = box->scene;
    std::optional<uint32_t> tree, animation;
    if (!scene_name.is_none())
        tree = find_scene(*scene, name_or_number(scene_name, "scene"));
    if (!animation_name.is_none())
        animation = find_animation(*scene, name_or_number(animation_name, "animation"));
    if ((time && !std::isfinite(*time)) || !(interval >= 0 && std::isfinite(interval)))
        throw UsageError("resolve: time is not finite, or interval below 0");
    check_scene(*scene);
    std::optional<Moment> moment;
    if (time)
        moment = Moment{*time, interval};
    return without_gil([&] { return WorldBox{scene, resolve(*scene, tree, moment, animation)}; });
}

// Adding.

Entry<Node> add_node(const Box& box, Node node, const std::optional<Entry<Node>>& parent) {
    const size_t above = parent ? parent->index_in(box.get(), "parent") : 0;
    Scene& scene = box->edit();
    const auto index = uint32_t(scene.nodes.size());
    scene.nodes.push_back(std::move(node));
    (parent ? scene.nodes[above].children : scene.scenes.at(scene.default_scene).nodes).push_back(index);
    return scene_entries<&Scene::nodes>(box).at(index);
}

/// Without the white one that add_mesh() makes where it is told none.
uint32_t material_given(const Box& box, const std::optional<Entry<Material>>& material) {
    if (material)
        return material->index_in(box.get(), "material");
    if (box->scene->materials.empty())
        box->edit().materials.push_back(Material{.name = "white", .metallic = 0});
    return 0;
}

uint32_t add_image(const Box& box, const ArrayLike& pixels, std::string name) {
    const auto array = to_array<uint8_t>(pixels, "pixels");
    if (py::array::ensure(pixels.object).itemsize() != 1)
        throw UsageError("pixels: uint8 is needed, not " + shape_of(py::array::ensure(pixels.object)));
    if (array.ndim() != 3 || (array.shape(2) != 3 && array.shape(2) != 4) || array.size() == 0)
        throw UsageError("pixels: an array of shape (height, width, 3 or 4) is needed, not " + shape_of(array));
    if (array.shape(0) > 16384 || array.shape(1) > 16384)
        throw UsageError("pixels: larger than 16384 across: " + shape_of(array));
    TextureImage image{.name = std::move(name), .width = uint32_t(array.shape(1)), .height = uint32_t(array.shape(0))};
    const auto channels = size_t(array.shape(2));
    image.rgba.resize(size_t(image.width) * image.height * 4, 255);
    for (size_t pixel = 0; pixel < image.rgba.size() / 4; ++pixel)
        std::copy_n(array.data() + pixel * channels, channels, &image.rgba[pixel * 4]);
    Scene& scene = box->edit();
    scene.images.push_back(std::move(image));
    return uint32_t(scene.images.size() - 1);
}

glm::dmat4 placed_at(const glm::dmat3& axes, const glm::dvec3& position) {
    glm::dmat4 matrix(axes);
    matrix[3] = glm::dvec4(position, 1);
    return matrix;
}

void bind_adding(py::class_<SceneBox, Box>& scene) {
    scene.def(
        "add_material",
        [](const Box& box, const Entry<Material>& material) {
            Material copy = material.get();
            box->edit().materials.push_back(std::move(copy));
            return scene_entries<&Scene::materials>(box).at(-1);
        },
        py::arg("material"), "Adds a copy, and returns the one of the scene.");
    scene.def("add_image", &add_image, py::arg("pixels"), py::arg("name") = "",
              "Adds a picture for textures, (height, width, 3 or 4) uint8, rows from the top, and returns its number.");
    scene.def(
        "add_mesh",
        [](const Box& box, const ArrayLike& positions, const ArrayLike& indices,
           const std::optional<ArrayLike>& normals, const std::optional<ArrayLike>& texcoords,
           const std::optional<ArrayLike>& colours, const std::optional<ArrayLike>& tangents,
           const std::optional<Entry<Material>>& material, std::string name) {
            Mesh mesh{.name = std::move(name),
                      .primitives = {make_primitive({positions, indices, normals, texcoords, colours, tangents})}};
            mesh.primitives[0].material = material_given(box, material);
            box->edit().meshes.push_back(std::move(mesh));
            return scene_entries<&Scene::meshes>(box).at(-1);
        },
        py::arg("positions"), py::arg("indices"), py::kw_only(), py::arg("normals") = py::none(),
        py::arg("texcoords") = py::none(), py::arg("colours") = py::none(), py::arg("tangents") = py::none(),
        py::arg("material") = py::none(), py::arg("name") = "",
        "Adds triangles: positions (N, 3), object space, metres; indices (M, 3), whole numbers, counter-clockwise seen "
        "from "
        "the front; normals (N, 3), without them each triangle is flat; texcoords (N, 2), (0, 0) is the image's top "
        "left; "
        "colours (N, 4), linear RGBA in 0 ... 1; tangents (N, 4), for normal maps. Shown where add_node() puts it.");
    scene.def(
        "add_node",
        [](const Box& box, const std::optional<Entry<Mesh>>& mesh, const std::optional<ArrayLike>& matrix,
           const std::optional<Entry<Node>>& parent, std::string name, bool visible) {
            Node node{.name = std::move(name), .visible = visible};
            if (mesh)
                node.mesh = mesh->index_in(box.get(), "mesh");
            if (matrix)
                node.local = to_affine(*matrix, "matrix");
            return add_node(box, std::move(node), parent);
        },
        py::arg("mesh") = py::none(), py::kw_only(), py::arg("matrix") = py::none(), py::arg("parent") = py::none(),
        py::arg("name") = "", py::arg("visible") = true,
        "Adds a place: matrix (4, 4), to the parent's space, or to the world's.");
    scene.def(
        "add_light",
        [](const Box& box, const Entry<PlacedLight>& light, const std::optional<Entry<Node>>& parent) {
            const PlacedLight placed = light.get();
            check_lights_given(*box->scene, {placed});
            Node node{.name = placed.light.name, .local = placed_at(light_axes(placed), placed.position)};
            node.light = uint32_t(box->scene->lights.size());
            const auto made = add_node(box, std::move(node), parent);
            box->edit().lights.push_back(placed.light);
            return made;
        },
        py::arg("light"), py::kw_only(), py::arg("parent") = py::none(),
        "Adds a copy, in a node of its own, which is returned. A light for one world alone goes into World.lights.");
    scene.def(
        "add_camera",
        [](const Box& box, const Entry<PlacedCamera>& camera, const std::optional<Entry<Node>>& parent) {
            const PlacedCamera placed = camera.get();
            check_camera(placed);
            Node node{.name = placed.camera.name, .local = placed_at(placed.axes, placed.position)};
            node.camera = uint32_t(box->scene->cameras.size());
            const auto made = add_node(box, std::move(node), parent);
            box->edit().cameras.push_back(placed.camera);
            return made;
        },
        py::arg("camera"), py::kw_only(), py::arg("parent") = py::none(),
        "Adds a copy, in a node of its own, which is returned.");
}

// Environment and shaders.

Environment environment_given(const py::object& given) {
    if (py::isinstance<py::str>(given)) {
        const auto name = given.cast<std::string>();
        for (const BuiltinEnvironment& known : builtin_environments())
            if (known.name == name)
                return without_gil([&] { return make_environment(name); });
    }
    if (py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__")) {
        const auto path = given.cast<Path>();
        return without_gil([&] { return load_environment(path); });
    }
    const GivenPicture picture({given}, "environment");
    const Image& image = picture.image();
    if (image.width != 2 * image.height || image.width > 16384)
        throw UsageError("environment: a picture twice as wide as high, at most 16384, is needed, not " +
                         std::to_string(image.width) + " x " + std::to_string(image.height));
    for (const glm::vec3& p : image.pixels)
        if (!(p.x >= 0 && p.y >= 0 && p.z >= 0 && std::isfinite(p.x + p.y + p.z)))
            throw UsageError("environment: a value is below 0 or not finite");
    return {.name = "array", .image = image};
}

void set_environment(const Box& box, const py::object& given, float intensity, double rotation, bool background) {
    if (given.is_none()) {
        box->edit().environment = nullptr;
        return;
    }
    if (!(intensity >= 0 && std::isfinite(intensity)) || !std::isfinite(rotation))
        throw UsageError("environment: intensity is not a finite number of 0 or more, or rotation not finite");
    auto environment = std::make_shared<Environment>(environment_given(given));
    environment->intensity = intensity;
    environment->rotation = rotation;
    environment->background = background;
    box->edit().environment = std::move(environment);
}

void assign_shader(const Box& box, const std::string& material, const py::object& shader) {
    std::shared_ptr<const MaterialShader> found;
    if (py::isinstance<py::str>(shader))
        found = find_material_shader(shader.cast<std::string>());
    if (!found) {
        const auto path = shader.cast<Path>();
        found = without_gil([&] {
            auto loaded = load_material_shader(path);
            check_material_shader(*loaded);
            return loaded;
        });
    }
    Scene changed = *box->scene;
    assign_material_shader(changed, material, std::move(found));
    box->scene = std::make_shared<Scene>(std::move(changed));
}

void bind_nodes(py::module_& module) {
    py::class_<Entry<Node>> node(module, "Node", "A place in a scene. Scene.add_node() makes one.");
    field(
        node, "name", [](auto& n) -> auto& { return n.name; }, "For messages.");
    field(
        node, "visible", [](auto& n) -> auto& { return n.visible; },
        "False hides mesh and light of the node and of all below it.");
    node.def_property(
        "matrix", [](const Entry<Node>& entry) { return from_matrix(entry.get().local); },
        [](Entry<Node>& entry, const ArrayLike& given) {
            const glm::dmat4 matrix = to_affine(given, "matrix");
            if (entry.get().trs)
                for (const Animation& animation : entry.owner_as<SceneBox>().scene->animations)
                    for (const AnimationChannel& channel : animation.channels)
                        if (channel.node == *entry.index() && channel.path != AnimationPath::weights)
                            throw UsageError("node \"" + entry.get().name + "\": animation \"" + animation.name +
                                             "\" moves it");
            Node& edited = entry.edit();
            edited.local = matrix;
            edited.trs.reset();
        },
        "(4, 4) float64, to the parent's space, for column vectors.");
    node.def_property_readonly(
        "index", [](const Entry<Node>& entry) { return entry.index().value(); }, "Its number in the scene.");
    node.def_property_readonly(
        "mesh", [](const Entry<Node>& entry) { return entry.get().mesh; }, "Number, or None.");
    node.def_property_readonly(
        "children", [](const Entry<Node>& entry) { return entry.get().children; }, "Numbers of nodes.");
    node.def("__repr__", [](const Entry<Node>& entry) {
        return py::str("Node({!r}, mesh={}, children={})")
            .format(entry.get().name, entry.get().mesh, entry.get().children);
    });
    bind_entries<Node>(module, "NodeList", "The nodes of a scene; Scene.add_node() adds one.");
}

template <class T>
std::vector<std::string> names_of(const std::vector<T>& objects) {
    std::vector<std::string> names;
    for (const T& object : objects)
        names.push_back(object.name);
    return names;
}

void bind_making(py::module_& module) {
    py::class_<BuiltinScene>(module, "BuiltinScene", "What make_scene() can make.")
        .def_property_readonly(
            "name", [](const BuiltinScene& s) { return std::string(s.name); }, "For make_scene().")
        .def_property_readonly(
            "description", [](const BuiltinScene& s) { return std::string(s.description); }, "One line.")
        .def_readonly("default_lights", &BuiltinScene::default_lights, "How many lights it has unless told otherwise.")
        .def("__repr__", [](const BuiltinScene& s) {
            return py::str("BuiltinScene({!r}, {!r})").format(std::string(s.name), std::string(s.description));
        });
    module.def("builtin_scenes", &builtin_scenes, "The scenes that make_scene() can make.");
    module.def(
        "make_scene",
        [](const std::string& name, std::optional<uint32_t> lights, uint64_t seed) {
            if (!lights)
                for (const BuiltinScene& known : builtin_scenes())
                    if (known.name == name)
                        lights = known.default_lights;
            return boxed(without_gil([&] { return make_scene(name, lights.value_or(1), seed); }));
        },
        py::arg("name"), py::arg("lights") = py::none(), py::arg("seed") = 1,
        "A built-in scene (builtin_scenes()). lights: 1 ... 65,536; without it the scene's own number. The same "
        "arguments "
        "give the same scene everywhere. Raises UsageError.");
    module.def(
        "load_gltf",
        [](const Path& path, bool strict, uint64_t memory_limit) {
            return boxed(without_gil([&] { return load_gltf(path, {strict, memory_limit}); }));
        },
        py::arg("path"), py::kw_only(), py::arg("strict") = false, py::arg("memory_limit") = 0,
        "Reads glTF 2.0, .gltf or .glb. What is repaired or left out is in Scene.warnings; strict: such a line is an "
        "Error. "
        "memory_limit: bytes that reading may plan with, 0: what the machine can spare. Raises Error.");
}

} // namespace

void bind_scenes(py::module_& module) {
    bind_nodes(module);
    py::class_<SceneBox, Box> scene(
        module, "Scene",
        "Meshes, materials, images, lights and cameras, in trees of nodes: what a glTF file holds. "
        "Worlds that were resolved from it stay as they are when it changes.");
    scene.def(py::init([](std::string name) {
                  Scene empty;
                  empty.name = std::move(name);
                  empty.scenes = {{.name = "", .nodes = {}}};
                  return boxed(std::move(empty));
              }),
              py::arg("name") = "scene");
    scene.def_property_readonly(
        "name", [](const Box& box) { return box->scene->name; }, "File or built-in name.");
    scene.def_property_readonly(
        "warnings", [](const Box& box) { return box->scene->warnings; },
        "What the reader repaired or left out: \"FILE: OBJECT: REASON\", one line each.");
    scene.def_property_readonly("materials", &scene_entries<&Scene::materials>, "May be changed, not removed.");
    scene.def_property_readonly("meshes", &scene_entries<&Scene::meshes>, "In the file's order, then those added.");
    scene.def_property_readonly("nodes", &scene_entries<&Scene::nodes>, "In the file's order, then those added.");
    scene.def_property_readonly(
        "images", [](const Box& box) { return names_of(box->scene->images); }, "Their names.");
    scene.def_property_readonly(
        "scenes", [](const Box& box) { return names_of(box->scene->scenes); }, "Names of its trees, for resolve().");
    scene.def_property_readonly(
        "animations", [](const Box& box) { return names_of(box->scene->animations); }, "Their names, for resolve().");
    scene.def_property_readonly(
        "is_lit", [](const Box& box) { return is_lit(*box->scene); }, "Whether anything shines in its default tree.");
    scene.def_property_readonly(
        "has_camera", [](const Box& box) { return has_camera(*box->scene); }, "Whether its default tree has a camera.");
    scene.def_property(
        "ambient", [](const Box& box) { return from_vector(box->scene->ambient); },
        [](const Box& box, const ArrayLike& given) {
            const auto ambient = to_vector<glm::vec3>(given, "ambient");
            if (glm::any(glm::lessThan(ambient, glm::vec3(0))))
                throw UsageError("ambient: below 0");
            box->edit().ambient = ambient;
        },
        "(3,) float32: light from all around, linear RGB radiance. An environment takes its place.");
    scene.def_property_readonly(
        "environment",
        [](const Box& box) {
            return box->scene->environment ? std::optional(box->scene->environment->name) : std::nullopt;
        },
        "Its name, or None.");
    scene.def(
        "set_environment", &set_environment, py::arg("environment"), py::kw_only(), py::arg("intensity") = 1.0f,
        py::arg("rotation") = 0.0, py::arg("background") = true,
        "Light from all around: \"studio\", a picture's file (.hdr, .exr, .png), an array (height, 2 x height, 3) of "
        "linear radiance, or None. intensity: a factor; rotation: radians about +Y; background: whether it is seen. "
        "Raises Error.");
    scene.def("assign_shader", &assign_shader, py::arg("material"), py::arg("shader"),
              "Gives all materials of that name a shader: a built-in one's name (material_shaders()) or a GLSL file "
              "(docs/materials.md). Raises Error with \"FILE:LINE: REASON\".");
    scene.def(
        "resolve", &resolved, py::arg("scene") = py::none(), py::kw_only(), py::arg("time") = py::none(),
        py::arg("interval") = 1.0 / 60, py::arg("animation") = py::none(),
        "The world of one of its trees (name or number; None: the default one). time: seconds, as the animations have "
        "it then; interval: seconds that motion is measured over; animation: only this one (name or number).");
    scene.def(
        "save_glb",
        [](const Box& box, const Path& path) {
            const std::shared_ptr<const Scene> kept = box->scene;
            check_scene(*kept);
            without_gil([&] { save_glb(*kept, path); });
        },
        py::arg("path"), "Writes it as .glb. The file appears when it is whole. Raises Error.");
    bind_adding(scene);
    scene.def("__repr__", [](const Box& box) {
        const Scene& s = *box->scene;
        return py::str("Scene({!r}, meshes={}, materials={}, nodes={}, lights={})")
            .format(s.name, s.meshes.size(), s.materials.size(), s.nodes.size(), s.lights.size());
    });
    bind_making(module);
}

} // namespace prelight::python
