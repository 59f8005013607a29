#include "boxes.hpp"
#include "words.hpp"
#include <numbers>
#include <prelight/framing.hpp>

namespace prelight::python {
namespace {

Camera projection(ProjectionKind kind, double yfov, double ymag, double znear, double zfar, std::string name) {
    return {.name = std::move(name), .kind = kind, .yfov = yfov, .ymag = ymag, .znear = znear, .zfar = zfar};
}

constexpr double infinity = std::numeric_limits<double>::infinity();

py::str camera_repr(const Entry<PlacedCamera>& entry) {
    const PlacedCamera& placed = entry.get();
    return py::str("Camera({!r}, name={!r}, position=({:.6g}, {:.6g}, {:.6g}))")
        .format(py::cast(placed.camera.kind).attr("value"), placed.camera.name, placed.position.x, placed.position.y,
                placed.position.z);
}

} // namespace

void check_camera(const PlacedCamera& placed) {
    const Camera& camera = placed.camera;
    const auto refuse = [&](const std::string& why) { throw UsageError("camera \"" + camera.name + "\": " + why); };
    const bool perspective = camera.kind == ProjectionKind::perspective;
    if (perspective && !(camera.yfov > 0 && camera.yfov < std::numbers::pi))
        refuse("yfov is not between 0 and pi");
    if (!perspective && !(camera.ymag > 0 && std::isfinite(camera.ymag)))
        refuse("ymag is not above 0");
    if (!(perspective ? camera.znear > 0 : camera.znear >= 0) || !std::isfinite(camera.znear))
        refuse(perspective ? "znear is not above 0" : "znear is below 0");
    if (!(camera.zfar > camera.znear))
        refuse("zfar is not beyond znear");
    if (!perspective && !std::isfinite(camera.zfar))
        refuse("zfar is infinite, which only a perspective camera may have");
    const glm::dmat3 product = glm::transpose(placed.axes) * placed.axes;
    for (int i = 0; i < 3; ++i)
        if (!(glm::length(product[i] - glm::dmat3(1)[i]) < 1e-6))
            refuse("axes are not three unit vectors at right angles");
    if (!(glm::determinant(placed.axes) > 0))
        refuse("axes mirror");
}

CameraWish camera_wish(const py::object& given) {
    if (given.is_none())
        return {};
    if (py::isinstance<Entry<PlacedCamera>>(given))
        return {.camera = given.cast<const Entry<PlacedCamera>&>().get(), .name = {}};
    if (py::isinstance<py::str>(given) || py::isinstance<py::int_>(given))
        return {.camera = {}, .name = py::str(given).cast<std::string>()};
    throw py::type_error("camera: a Camera, a name or a number is needed, not " + shape_of(given));
}

PlacedCamera find(const CameraWish& wish, const World& world, double aspect) {
    PlacedCamera camera;
    if (wish.camera)
        camera = *wish.camera;
    else if (wish.name)
        camera = find_camera(world, *wish.name);
    else if (world.cameras.empty())
        throw UsageError("camera: the world has none");
    else if (world.framed && world.cameras[0].camera.name == "framed")
        camera = frame(world, aspect); // resolve() made it for a square picture
    else
        camera = world.cameras[0];
    check_camera(camera);
    return camera;
}

void bind_cameras(py::module_& module) {
    py::class_<Entry<PlacedCamera>> camera(module, "Camera",
                                           "A camera in the world. It looks along its own -Z, +Y is up. The picture's "
                                           "width / height decides the horizontal "
                                           "extent. Out-of-range values are refused where the camera is used.");
    camera.def(py::init([](ProjectionKind kind, const ArrayLike& position, const ArrayLike& axes, double yfov,
                           double ymag, double znear, double zfar, std::string name) {
                   return Entry<PlacedCamera>({.camera = projection(kind, yfov, ymag, znear, zfar, std::move(name)),
                                               .position = to_vector<glm::dvec3>(position, "position"),
                                               .axes = to_matrix<glm::dmat3>(axes, "axes")});
               }),
               py::arg("kind") = ProjectionKind::perspective, py::kw_only(),
               py::arg("position") = ArrayLike{py::make_tuple(0, 0, 0)},
               py::arg("axes") =
                   ArrayLike{py::make_tuple(py::make_tuple(1, 0, 0), py::make_tuple(0, 1, 0), py::make_tuple(0, 0, 1))},
               py::arg("yfov") = 0.87, py::arg("ymag") = 1.0, py::arg("znear") = 0.1, py::arg("zfar") = infinity,
               py::arg("name") = "");
    camera.def_static(
        "look_at",
        [](const ArrayLike& eye, const ArrayLike& target, const ArrayLike& up, ProjectionKind kind, double yfov,
           double ymag, double znear, double zfar, std::string name) {
            const auto from = to_vector<glm::dvec3>(eye, "eye"), to = to_vector<glm::dvec3>(target, "target");
            const auto upwards = to_vector<glm::dvec3>(up, "up");
            if (from == to)
                throw UsageError("look_at: eye and target are the same point");
            if (!(glm::length(glm::cross(upwards, from - to)) > 1e-12 * glm::length(upwards) * glm::length(from - to)))
                throw UsageError("look_at: up lies along the view, or is zero");
            return Entry<PlacedCamera>(
                look_at(projection(kind, yfov, ymag, znear, zfar, std::move(name)), from, to, upwards));
        },
        py::arg("eye"), py::arg("target"), py::arg("up") = ArrayLike{py::make_tuple(0, 1, 0)}, py::kw_only(),
        py::arg("kind") = ProjectionKind::perspective, py::arg("yfov") = 0.87, py::arg("ymag") = 1.0,
        py::arg("znear") = 0.1, py::arg("zfar") = infinity, py::arg("name") = "",
        "A camera at eye (world, metres) that looks at target; up need not be at a right angle.");
    field(
        camera, "name", [](auto& c) -> auto& { return c.camera.name; }, "For Renderer.render(camera=NAME).");
    field(
        camera, "kind", [](auto& c) -> auto& { return c.camera.kind; }, "perspective or orthographic.");
    field(
        camera, "yfov", [](auto& c) -> auto& { return c.camera.yfov; },
        "Radians, full vertical angle, above 0 and below pi (perspective).");
    field(
        camera, "ymag", [](auto& c) -> auto& { return c.camera.ymag; },
        "Metres, half the height of the view (orthographic).");
    field(
        camera, "znear", [](auto& c) -> auto& { return c.camera.znear; }, "Metres; above 0 for perspective.");
    field(
        camera, "zfar", [](auto& c) -> auto& { return c.camera.zfar; }, "Metres; infinite: perspective only.");
    vector_field(
        camera, "position", [](auto& c) -> auto& { return c.position; }, "(3,) float64, world, metres.");
    camera.def_property(
        "axes", [](const Entry<PlacedCamera>& entry) { return from_matrix(entry.get().axes); },
        [](Entry<PlacedCamera>& entry, const ArrayLike& axes) {
            const auto value = to_matrix<glm::dmat3>(axes, "axes");
            entry.edit().axes = value;
        },
        "(3, 3) float64; columns: right, up, backwards; orthonormal, world space.");
    camera.def("__repr__", &camera_repr);
    bind_editable_entries<PlacedCamera>(module, "CameraList", "The cameras of a world.");
}

} // namespace prelight::python
