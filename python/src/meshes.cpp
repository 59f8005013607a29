#include "meshes.hpp"

namespace prelight::python {
namespace {

/// (count, N) float32; count 0: any number of them.
template <class Vector>
std::vector<Vector> rows(const ArrayLike& given, const std::string& what, size_t count = 0) {
    const auto array = to_array<float>(given, what);
    constexpr py::ssize_t width = Vector::length();
    if (array.ndim() != 2 || array.shape(1) != width || (count > 0 && array.shape(0) != py::ssize_t(count)))
        throw UsageError(what + ": an array of shape (" + (count > 0 ? std::to_string(count) : "N") + ", " +
                         std::to_string(width) + ") is needed, not " + shape_of(array));
    const float* const data = array.data();
    for (py::ssize_t i = 0; i < array.size(); ++i)
        if (!std::isfinite(data[i]))
            throw UsageError(what + "[" + std::to_string(i / width) + "]: not finite");
    std::vector<Vector> vectors(size_t(array.shape(0)));
    if (!vectors.empty())
        std::copy_n(data, array.size(), &vectors[0][0]);
    return vectors;
}

std::vector<uint32_t> triangles(const ArrayLike& given, size_t vertices) {
    const auto array = to_array<int64_t>(given, "indices");
    if (array.ndim() != 2 || array.shape(1) != 3)
        throw UsageError("indices: an array of shape (M, 3) is needed, not " + shape_of(array));
    if (array.size() > py::ssize_t(0xffffffff))
        throw UsageError("indices: more than 4294967295");
    std::vector<uint32_t> indices(size_t(array.size()));
    for (size_t i = 0; i < indices.size(); ++i) {
        const int64_t index = array.data()[i];
        if (index < 0 || index >= int64_t(vertices))
            throw UsageError("indices[" + std::to_string(i / 3) + "]: " + std::to_string(index) + " is none of the " +
                             std::to_string(vertices) + " vertices");
        indices[i] = uint32_t(index);
    }
    return indices;
}

void make_unit(std::vector<glm::vec3>& vectors, const std::string& what) {
    for (size_t i = 0; i < vectors.size(); ++i) {
        const float length = glm::length(vectors[i]);
        if (!(length > 0 && std::isfinite(length)))
            throw UsageError(what + "[" + std::to_string(i) + "]: has no direction");
        vectors[i] /= length;
    }
}

template <class T>
void spread_out(std::vector<T>& vertices, const std::vector<uint32_t>& indices) {
    if (vertices.empty())
        return;
    std::vector<T> spread(indices.size());
    for (size_t i = 0; i < indices.size(); ++i)
        spread[i] = vertices[indices[i]];
    vertices = std::move(spread);
}

/// Each triangle gets vertices of its own, with its own normal: what glTF says of a mesh without normals.
void flatten(Primitive& primitive) {
    spread_out(primitive.positions, primitive.indices);
    spread_out(primitive.tangents, primitive.indices);
    spread_out(primitive.texcoords[0], primitive.indices);
    spread_out(primitive.colours, primitive.indices);
    primitive.normals.resize(primitive.positions.size());
    for (size_t i = 0; i < primitive.positions.size(); ++i)
        primitive.indices[i] = uint32_t(i);
    for (size_t i = 0; i < primitive.positions.size(); i += 3) {
        const glm::vec3* const corner = &primitive.positions[i];
        const glm::dvec3 across = glm::cross(glm::dvec3(corner[1] - corner[0]), glm::dvec3(corner[2] - corner[0]));
        const double length = glm::length(across);
        const glm::vec3 normal = length > 0 ? glm::vec3(across / length) : glm::vec3(0, 1, 0); // no area, never seen
        std::fill_n(&primitive.normals[i], 3, normal);
    }
    primitive.flat_normals = true;
}

/// One of a mesh's primitives, found anew at each use.
struct PrimitiveEntry {
    std::shared_ptr<SceneBox> box;
    size_t mesh, index;
    const Primitive& get() const { return box->scene->meshes.at(mesh).primitives.at(index); }
};

template <class Vector>
py::object vertex_view(const PrimitiveEntry& entry, const std::vector<Vector>& vertices) {
    if (vertices.empty())
        return py::none();
    std::shared_ptr<const Scene> scene = entry.box->scene;
    return view(&vertices[0][0], {py::ssize_t(vertices.size()), py::ssize_t(Vector::length())}, keep(std::move(scene)));
}

} // namespace

Primitive make_primitive(const GivenMesh& given) {
    Primitive primitive;
    primitive.positions = rows<glm::vec3>(given.positions, "positions");
    const size_t count = primitive.positions.size();
    if (count == 0)
        throw UsageError("positions: there are none");
    primitive.indices = triangles(given.indices, count);
    if (primitive.indices.empty())
        throw UsageError("indices: there are none");
    if (given.texcoords)
        primitive.texcoords[0] = rows<glm::vec2>(*given.texcoords, "texcoords", count);
    if (given.colours)
        primitive.colours = rows<glm::vec4>(*given.colours, "colours", count);
    for (size_t i = 0; i < primitive.colours.size(); ++i)
        if (glm::any(glm::lessThan(primitive.colours[i], glm::vec4(0))) ||
            glm::any(glm::greaterThan(primitive.colours[i], glm::vec4(1))))
            throw UsageError("colours[" + std::to_string(i) + "]: not in 0 ... 1");
    if (given.tangents) {
        primitive.tangents = rows<glm::vec4>(*given.tangents, "tangents", count);
        for (size_t i = 0; i < count; ++i) {
            const glm::vec4 tangent = primitive.tangents[i];
            if (!(std::abs(glm::length(glm::vec3(tangent)) - 1) < 1e-3f && std::abs(tangent.w) == 1))
                throw UsageError("tangents[" + std::to_string(i) + "]: not a unit vector and 1 or -1");
        }
    }
    if (given.normals) {
        primitive.normals = rows<glm::vec3>(*given.normals, "normals", count);
        make_unit(primitive.normals, "normals");
    } else {
        flatten(primitive);
    }
    return primitive;
}

void bind_meshes(py::module_& module) {
    py::class_<PrimitiveEntry> primitive(module, "Primitive",
                                         "Triangles with one material. Its arrays are views of the scene's memory.");
    primitive.def_property_readonly(
        "positions", [](const PrimitiveEntry& e) { return vertex_view(e, e.get().positions); },
        "(N, 3) float32, object space, metres.");
    primitive.def_property_readonly(
        "normals", [](const PrimitiveEntry& e) { return vertex_view(e, e.get().normals); },
        "(N, 3) float32, unit length.");
    primitive.def_property_readonly(
        "tangents", [](const PrimitiveEntry& e) { return vertex_view(e, e.get().tangents); },
        "(N, 4) float32: a unit vector, and 1 or -1 for the bitangent; None: there are none.");
    primitive.def_property_readonly(
        "texcoords", [](const PrimitiveEntry& e) { return vertex_view(e, e.get().texcoords[0]); },
        "(N, 2) float32, (0, 0) is the image's top left; None: there are none.");
    primitive.def_property_readonly(
        "colours", [](const PrimitiveEntry& e) { return vertex_view(e, e.get().colours); },
        "(N, 4) float32, linear RGBA; None: white.");
    primitive.def_property_readonly(
        "indices",
        [](const PrimitiveEntry& e) {
            const std::vector<uint32_t>& indices = e.get().indices;
            std::shared_ptr<const Scene> scene = e.box->scene;
            return view(indices.data(), {py::ssize_t(indices.size() / 3), 3}, keep(std::move(scene)));
        },
        "(M, 3) uint32, counter-clockwise seen from the front.");
    primitive.def_property_readonly(
        "material", [](const PrimitiveEntry& e) { return e.get().material; },
        "Number of one of the scene's materials.");
    primitive.def("__repr__", [](const PrimitiveEntry& e) {
        return py::str("Primitive(vertices={}, triangles={}, material={})")
            .format(e.get().positions.size(), e.get().indices.size() / 3, e.get().material);
    });

    py::class_<Entry<Mesh>> mesh(module, "Mesh", "What a node shows. Scene.add_mesh() makes one.");
    field(
        mesh, "name", [](auto& m) -> auto& { return m.name; }, "For messages.");
    mesh.def_property_readonly(
        "index", [](const Entry<Mesh>& entry) { return entry.index().value(); }, "Its number in the scene.");
    mesh.def_property_readonly(
        "primitives",
        [](const Entry<Mesh>& entry) {
            std::vector<PrimitiveEntry> primitives;
            for (size_t i = 0; i < entry.get().primitives.size(); ++i)
                primitives.push_back({std::static_pointer_cast<SceneBox>(entry.owner()), entry.index().value(), i});
            return primitives;
        },
        "What it consists of, one for each material.");
    mesh.def("__repr__", [](const Entry<Mesh>& entry) {
        return py::str("Mesh({!r}, primitives={})").format(entry.get().name, entry.get().primitives.size());
    });
    bind_entries<Mesh>(module, "MeshList", "The meshes of a scene; Scene.add_mesh() adds one.");
}

} // namespace prelight::python
