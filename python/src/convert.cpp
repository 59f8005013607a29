#include "convert.hpp"
#include <algorithm>

namespace prelight::python {

std::string shape_of(const py::object& object) {
    if (py::isinstance<py::array>(object) && object.attr("dtype").attr("kind").cast<std::string>() != "O") {
        const auto array = object.cast<py::array>();
        std::string shape;
        for (py::ssize_t i = 0; i < array.ndim(); ++i)
            shape += (i ? ", " : "") + std::to_string(array.shape(i));
        return "(" + shape + (array.ndim() == 1 ? ",) of " : ") of ") + py::str(array.dtype()).cast<std::string>();
    }
    return py::type::of(object).attr("__name__").cast<std::string>();
}

Picture to_picture(Image image) {
    const auto height = py::ssize_t(image.height), width = py::ssize_t(image.width);
    const py::object owner = py::cast(std::make_unique<Image>(std::move(image)));
    const auto& kept = owner.cast<const Image&>();
    return {view(&kept.pixels.data()->x, {height, width, 3}, owner)};
}

Picture to_bytes(const Image& display) {
    auto bytes = std::make_shared<std::vector<uint8_t>>(display.pixels.size() * 3);
    without_gil([&] {
        const float* const values = display.pixels.empty() ? nullptr : &display.pixels[0].x;
        for (size_t i = 0; i < bytes->size(); ++i)
            (*bytes)[i] = uint8_t(std::lround(std::clamp(values[i], 0.0f, 1.0f) * 255.0f));
    });
    const uint8_t* const data = bytes->data();
    return {view(data, {py::ssize_t(display.height), py::ssize_t(display.width), 3}, keep(std::move(bytes)))};
}

GivenPicture::GivenPicture(const PictureLike& given, const std::string& what) {
    if (py::isinstance<Image>(given.object)) {
        keeper_ = given.object;
        shown_ = &keeper_.cast<const Image&>();
        return;
    }
    const py::array plain = py::array::ensure(given.object);
    if (!plain || plain.dtype().kind() == 'O' || plain.dtype().kind() == 'U') {
        PyErr_Clear();
        throw UsageError(what + ": a picture is needed, not " + shape_of(given.object));
    }
    if (plain.ndim() != 3 || plain.shape(2) != 3 || plain.size() == 0)
        throw UsageError(what + ": a picture of shape (height, width, 3) is needed, not " + shape_of(plain));
    if (plain.shape(0) > 65536 || plain.shape(1) > 65536)
        throw UsageError(what + ": larger than 65536 pixels across: " + shape_of(plain));
    const auto height = uint32_t(plain.shape(0)), width = uint32_t(plain.shape(1));
    if (plain.base() && py::isinstance<Image>(plain.base()) && plain.dtype().is(py::dtype::of<float>())) {
        keeper_ = py::reinterpret_borrow<py::object>(plain.base());
        const Image& image = keeper_.cast<const Image&>();
        if (plain.data() == image.pixels.data() && image.width == width && image.height == height &&
            (plain.flags() & py::array::c_style)) {
            shown_ = &image;
            return;
        }
    }
    const char kind = plain.dtype().kind();
    const bool bytes = kind == 'u' && plain.itemsize() == 1;
    if (!bytes && kind != 'f')
        throw UsageError(what + ": float or uint8 is needed, not " + shape_of(plain));
    const auto values = to_array<float>({plain}, what);
    copy_ = Image(width, height);
    std::copy_n(values.data(), values.size(), &copy_.pixels[0].x);
    if (bytes)
        for (glm::vec3& pixel : copy_.pixels)
            pixel /= 255.0f;
}

} // namespace prelight::python
