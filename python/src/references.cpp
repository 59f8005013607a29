#include "renderer_box.hpp"
#include "words.hpp"
#include <prelight/reference.hpp>

namespace prelight::python {
namespace {

/// One of the picture's lists as (height, width) or (height, width, 3), in its own memory.
template <class T>
py::array pixels(const py::object& self, const std::vector<T>& list) {
    const Image& picture = self.cast<const ReferencePicture&>().linear;
    std::vector<py::ssize_t> shape{py::ssize_t(picture.height), py::ssize_t(picture.width)};
    if constexpr (std::is_arithmetic_v<T>) {
        return view(list.data(), std::move(shape), self);
    } else {
        shape.push_back(T::length());
        return view(&list.data()->x, std::move(shape), self);
    }
}

template <auto Member>
py::array list_of(const py::object& self) {
    return pixels(self, self.cast<const ReferencePicture&>().*Member);
}

} // namespace

std::unique_ptr<ReferencePicture> reference_of(const World& world, const PlacedCamera& camera,
                                               const ReferenceRequest& r) {
    if (r.width == 0 || r.height == 0 || r.width > 65536 || r.height > 65536)
        throw UsageError("render_reference: a picture of " + std::to_string(r.width) + "x" + std::to_string(r.height) +
                         " pixels");
    if (!std::isfinite(r.exposure))
        throw UsageError("exposure: not finite");
    return without_gil([&] {
        return std::make_unique<ReferencePicture>(render_reference(world, camera, r.width, r.height, r.exposure,
                                                                   reference_form(r.shading, r.settings, r.msaa)));
    });
}

void bind_reference(py::module_& module) {
    py::class_<ReferencePicture>(
        module, "ReferencePicture",
        "A ray-cast picture, with what each pixel shows. The arrays are views of its memory, read-only.")
        .def_property_readonly(
            "linear",
            [](const py::object& self) { return pixels(self, self.cast<const ReferencePicture&>().linear.pixels); },
            "(height, width, 3) float32, exposed scene-linear.")
        .def_property_readonly("instance", &list_of<&ReferencePicture::instance>,
                               "(height, width) uint32: number in World.instances; 0xffffffff: background.")
        .def_property_readonly("primitive", &list_of<&ReferencePicture::primitive>,
                               "(height, width) uint32: number in the mesh.")
        .def_property_readonly("position", &list_of<&ReferencePicture::position>,
                               "(height, width, 3) float64: of the surface, world, metres.")
        .def_property_readonly("normal", &list_of<&ReferencePicture::normal>,
                               "(height, width, 3) float64: shading normal, world, unit length.")
        .def_property_readonly("depth", &list_of<&ReferencePicture::depth>,
                               "(height, width) float64: along the camera's axis, metres; infinite: background.")
        .def_property_readonly(
            "left_out",
            [](const ReferencePicture& picture) -> py::object {
                auto bytes = std::make_shared<std::vector<uint8_t>>(without_gil([&] { return picture.left_out(); }));
                const uint8_t* const data = bytes->data();
                const py::array array =
                    view(data, {py::ssize_t(picture.linear.height), py::ssize_t(picture.linear.width)},
                         keep(std::move(bytes)));
                return array.attr("view")("bool");
            },
            "(height, width) bool: where a picture cannot be judged (docs/measuring.md); for compare().")
        .def(
            "display",
            [](const ReferencePicture& picture, Tonemap curve) {
                return to_picture(without_gil([&] { return picture.display(curve); }));
            },
            py::arg("curve") = Tonemap::pbr_neutral, "(height, width, 3) float32, display-encoded, 0 ... 1.")
        .def("__repr__", [](const ReferencePicture& picture) {
            return py::str("ReferencePicture(width={}, height={})").format(picture.linear.width, picture.linear.height);
        });
    module.def(
        "render_reference",
        [](const std::shared_ptr<WorldBox>& box, const py::object& camera, uint32_t width, uint32_t height,
           double exposure, Shading shading, const py::dict& settings, uint32_t msaa) {
            const std::shared_ptr<const Scene> scene = box->scene;
            const World world = checked_copy(*box);
            const double aspect = height ? double(width) / height : 1;
            return reference_of(world, find(camera_wish(camera), world, aspect),
                                {width, height, exposure, shading, settings_given(settings), msaa});
        },
        py::arg("world"), py::arg("camera") = py::none(), py::kw_only(), py::arg("width") = 1280,
        py::arg("height") = 720, py::arg("exposure") = 0.0, py::arg("shading") = Shading::ggx,
        py::arg("settings") = py::dict(), py::arg("msaa") = 1,
        "Casts a ray for each sample and shades in double precision. settings: of the renderer whose picture it is for "
        "(Stats.settings), so that it evaluates the same form of the lighting model. exposure: EV. Raises Error.");
}

} // namespace prelight::python
