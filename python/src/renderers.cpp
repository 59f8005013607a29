#include "renderer_box.hpp"
#include "words.hpp"

namespace prelight::python {
namespace {

Picture read_as(RendererBox& renderer, const std::string& view, const py::object& dtype) {
    const py::dtype type = py::dtype::from_args(dtype);
    const bool bytes = type.equal(py::dtype::of<uint8_t>());
    if (!bytes && !type.equal(py::dtype::of<float>()))
        throw UsageError("read: dtype is float32 or uint8, not " + py::str(py::handle(type)).cast<std::string>());
    if (bytes && view == "linear")
        throw UsageError("read: linear values do not fit into uint8");
    Image image = renderer.read(view);
    return bytes ? to_bytes(image) : to_picture(std::move(image));
}

void bind_drawing(py::class_<RendererBox>& renderer) {
    renderer.def(
        "set_world", [](RendererBox& box, const std::shared_ptr<WorldBox>& world) { box.set_world(*world); },
        py::arg("world"),
        "Shows this world, as it is now. Of one that comes from the same scene only what differs is uploaded: call it "
        "for "
        "each moment of an animation. Raises Error, UsageError.");
    renderer.def(
        "set_lights",
        [](RendererBox& box, const py::object& lights) { box.set_lights(copies_of<PlacedLight>(lights)); },
        py::arg("lights"),
        "Takes other lights in place of the world's until set_world(): a LightList or any iterable of Light. Geometry "
        "and "
        "materials stay on the device. Raises Error, UsageError.");
    renderer.def("resize", &RendererBox::resize, py::arg("width"), py::arg("height"),
                 "Pictures of another size, pixels. Raises Error; the renderer is as before then.");
    renderer.def(
        "render", &RendererBox::render, py::arg("camera") = py::none(), py::arg("frames") = 1,
        py::arg("progress") = py::none(),
        "Draws. camera: a Camera, or name or number of one of the world's; None: its first, or one that shows all. "
        "frames: so many, one after the other, for the times in stats; Ctrl-C ends it between two. progress(done, "
        "frames) is called after each. Other threads run meanwhile. Raises Error, UsageError.");
    renderer.def(
        "read", &read_as, py::arg("view") = "final", py::arg("dtype") = "float32",
        "A buffer of the last frame, (height, width, 3), read-only; the array owns its memory. final is "
        "display-encoded, 0 ... 1; linear is exposed scene-linear; others must be among Renderer(views=...). dtype: "
        "float32, or uint8 (not for linear). Raises UsageError.");
    renderer.def(
        "reference", &RendererBox::reference,
        "The last frame by rays: its world, lights, camera, size, exposure and form of the lighting model. Raises "
        "Error.");
}

} // namespace

void bind_renderers(py::module_& module) {
    py::class_<RendererBox> renderer(module, "Renderer",
                                     "An architecture, made for one set of options; it shows any world. Threads may "
                                     "use it at the same time: they wait "
                                     "for each other. `with` closes it at the end.");
    renderer.def(
        py::init([](const std::string& name, const std::shared_ptr<DeviceBox>& device, uint32_t width, uint32_t height,
                    std::optional<Shading> shading, Tonemap tonemap, double exposure, uint32_t msaa, std::string preset,
                    const py::dict& settings, std::vector<std::string> views, bool count_pairs, bool pass_cpu) {
            RenderOptions options;
            options.width = width;
            options.height = height;
            options.shading = shading;
            options.tonemap = tonemap;
            options.exposure = exposure;
            options.msaa = msaa;
            options.preset = std::move(preset);
            options.settings = settings_given(settings);
            options.views = std::move(views);
            options.count_pairs = count_pairs;
            options.pass_cpu = pass_cpu;
            return std::make_unique<RendererBox>(name, device, std::move(options));
        }),
        py::arg("name") = "light-prepass", py::arg("device") = py::none(), py::kw_only(), py::arg("width") = 1280,
        py::arg("height") = 720, py::arg("shading") = py::none(), py::arg("tonemap") = Tonemap::pbr_neutral,
        py::arg("exposure") = 0.0, py::arg("msaa") = 1, py::arg("preset") = "", py::arg("settings") = py::dict(),
        py::arg("views") = std::vector<std::string>{}, py::arg("count_pairs") = false, py::arg("pass_cpu") = false,
        "name: see renderers(). device: None: one that all such renderers share. width, height: pixels. shading: None: "
        "the "
        "preset's, or ggx. exposure: EV. msaa: samples a pixel. settings: words or numbers, by RendererInfo.settings. "
        "views: "
        "buffers that read() will be asked for. count_pairs, pass_cpu: fill these of Stats, slower. Raises UsageError "
        "for "
        "what no renderer offers, Error where the device cannot.");
    bind_drawing(renderer);
    renderer.def_property_readonly("stats", &RendererBox::stats, "Figures of the last render(); waits for it.");
    renderer.def_property_readonly("max_lights", &RendererBox::max_lights,
                                   "The most lights that a world may have here.");
    renderer.def_property_readonly("name", &RendererBox::name, "As it was made.");
    renderer.def_property_readonly("device", &RendererBox::device, "None where it needs none.");
    renderer.def_property_readonly(
        "width", [](const RendererBox& box) { return box.options().width; }, "Pixels.");
    renderer.def_property_readonly(
        "height", [](const RendererBox& box) { return box.options().height; }, "Pixels.");
    renderer.def("close", &RendererBox::close, "Frees what it has on the device. It draws nothing any more.");
    renderer.def("__enter__", [](const py::object& self) { return self; });
    renderer.def("__exit__", [](RendererBox& box, const py::args&) { box.close(); });
    renderer.def("__repr__", [](const RendererBox& box) {
        return py::str("Renderer({!r}, width={}, height={})")
            .format(box.name(), box.options().width, box.options().height);
    });
}

} // namespace prelight::python
