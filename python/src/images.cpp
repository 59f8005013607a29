#include "convert.hpp"
#include "words.hpp"
#include <prelight/exposure.hpp>
#include <prelight/metrics.hpp>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace prelight::python {
namespace {

using Path = std::filesystem::path;

template <auto Save>
void bind_save(py::module_& module, const char* name, const char* doc) {
    module.def(
        name,
        [](const PictureLike& picture, const Path& path) {
            const GivenPicture given(picture, "picture");
            without_gil([&] { Save(given.image(), path); });
        },
        py::arg("picture"), py::arg("path"), doc);
}

template <auto Load>
void bind_load(py::module_& module, const char* name, const char* doc) {
    module.def(
        name, [](const Path& path) { return to_picture(without_gil([&] { return Load(path); })); }, py::arg("path"),
        doc);
}

std::vector<uint8_t> left_out_given(const std::optional<ArrayLike>& given, const Image& picture) {
    if (!given)
        return {};
    const auto array = to_array<uint8_t>(*given, "left_out");
    if (array.ndim() != 2 || array.shape(0) != py::ssize_t(picture.height) ||
        array.shape(1) != py::ssize_t(picture.width))
        throw UsageError("left_out: one value for each of the " + std::to_string(picture.height) + "x" +
                         std::to_string(picture.width) + " pixels is needed, not shape " + shape_of(array));
    return {array.data(), array.data() + array.size()};
}

void bind_comparison(py::module_& module) {
    py::class_<Comparison>(module, "Comparison",
                           "Figures of a picture against a reference (docs/measuring.md): both exposed so that the "
                           "reference's 99th percentile becomes 1, then clamped to 0 ... 1.")
        .def_readonly("psnr", &Comparison::psnr, "dB, of linear RGB; infinite when equal.")
        .def_readonly("flip", &Comparison::flip, "Mean FLIP, 0 ... 1, 67 pixels a degree.")
        .def_readonly("off_share", &Comparison::off_share,
                      "Share of the pixels with a channel off by more than 2/255 in sRGB.")
        .def_readonly("block", &Comparison::block,
                      "Largest difference of the means of a block of 16x16 pixels, sRGB, in 1/255.")
        .def_readonly("block_x", &Comparison::block_x, "Where that block begins, pixels from the left.")
        .def_readonly("block_y", &Comparison::block_y, "Pixels from the top.")
        .def_readonly("left_out_share", &Comparison::left_out_share, "Share of the pixels that left_out excludes.")
        .def("__repr__", [](const Comparison& c) {
            return py::str(
                       "Comparison(psnr={:.2f}, flip={:.5f}, off_share={:.5f}, block={:.2f}, left_out_share={:.4f})")
                .format(c.psnr, c.flip, c.off_share, c.block, c.left_out_share);
        });
    module.def(
        "compare",
        [](const PictureLike& picture, const PictureLike& reference, const std::optional<ArrayLike>& left_out) {
            const GivenPicture a(picture, "picture"), b(reference, "reference");
            const std::vector<uint8_t> excluded = left_out_given(left_out, a.image());
            return without_gil([&] { return compare(a.image(), b.image(), excluded); });
        },
        py::arg("picture"), py::arg("reference"), py::arg("left_out") = py::none(),
        "Figures of a scene-linear picture against a scene-linear reference, (height, width, 3) both. left_out: "
        "(height, "
        "width), true where a pixel does not count. Raises Error when sizes differ or a value is NaN.");
    module.def(
        "flip_map",
        [](const PictureLike& picture, const PictureLike& reference, double pixels_per_degree) {
            const GivenPicture a(picture, "picture"), b(reference, "reference");
            if (!(pixels_per_degree > 0 && pixels_per_degree < 1e6))
                throw UsageError("pixels_per_degree: a number above 0 is needed");
            if (a.image().width != b.image().width || a.image().height != b.image().height)
                throw UsageError("flip_map: the pictures are of different sizes");
            return to_picture(without_gil([&] { return flip_map(a.image(), b.image(), pixels_per_degree); }));
        },
        py::arg("picture"), py::arg("reference"), py::arg("pixels_per_degree") = 67.0,
        "FLIP, 0 ... 1 for each pixel (the same in the three channels), of two display-encoded pictures in 0 ... 1.");
}

} // namespace

void bind_images(py::module_& module) {
    py::class_<Image>(
        module, "Image", py::buffer_protocol(),
        "The memory of a picture, the base of the arrays that show it: (height, width, 3) float32, read-only. "
        "numpy.asarray(image) is another view of it.")
        .def_readonly("width", &Image::width, "Pixels.")
        .def_readonly("height", &Image::height, "Pixels.")
        .def("__repr__",
             [](const Image& image) { return py::str("Image(width={}, height={})").format(image.width, image.height); })
        .def_buffer([](Image& image) {
            const auto row = py::ssize_t(image.width * sizeof(glm::vec3));
            return py::buffer_info(reinterpret_cast<float*>(image.pixels.data()), // NOLINT: three floats each
                                   {py::ssize_t(image.height), py::ssize_t(image.width), py::ssize_t(3)},
                                   {row, py::ssize_t(sizeof(glm::vec3)), py::ssize_t(sizeof(float))}, true);
        });
    bind_save<&save_png>(module, "save_png",
                         "Writes an 8-bit PNG of a display-encoded picture, (height, width, 3): floats are clamped to "
                         "0 ... 1. The file appears when it is whole. Raises Error.");
    bind_save<&save_exr>(
        module, "save_exr",
        "Writes a half-float OpenEXR file of a scene-linear picture, (height, width, 3). The file appears "
        "when it is whole. Raises Error.");
    bind_load<&load_png>(module, "load_png",
                         "Reads a PNG: (height, width, 3) float32, 0 ... 1 as stored (display-encoded). Raises Error.");
    bind_load<&load_exr>(module, "load_exr",
                         "Reads RGB of an OpenEXR file: (height, width, 3) float32, scene-linear. Raises Error.");
    bind_load<&load_hdr>(module, "load_hdr",
                         "Reads a Radiance picture: (height, width, 3) float32, scene-linear. Raises Error.");
    module.def(
        "tonemap",
        [](const PictureLike& linear, Tonemap curve) {
            const GivenPicture given(linear, "linear");
            return to_picture(without_gil([&] { return tonemap(given.image(), curve); }));
        },
        py::arg("linear"), py::arg("curve") = Tonemap::pbr_neutral,
        "A scene-linear picture as a display shows it: (height, width, 3) float32, sRGB-encoded, 0 ... 1.");
    module.def(
        "auto_exposure",
        [](const PictureLike& linear) {
            const GivenPicture given(linear, "linear");
            return without_gil(
                [&] { return auto_exposure(given.image(), std::vector<bool>(given.image().pixels.size())); });
        },
        py::arg("linear"), "The exposure in EV that suits a scene-linear picture; None for a black one.");
    bind_comparison(module);
}

} // namespace prelight::python
