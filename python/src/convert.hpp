#pragma once
#include "module.hpp"
#include <cmath>
#include <glm/glm.hpp>
#include <memory>
#include <prelight/error.hpp>
#include <prelight/image.hpp>
#include <pybind11/numpy.h>
#include <string>
#include <vector>

namespace prelight::python {

/// Whatever numpy.asarray() takes.
struct ArrayLike {
    py::object object = py::none();
};
/// A picture that somebody gives: (height, width, 3), float or uint8.
struct PictureLike {
    py::object object = py::none();
};
/// A picture as numpy has it, for signatures.
struct Picture {
    py::array array;
};

/// "(2, 3)"; "str" of what is no array of numbers.
std::string shape_of(const py::object& object);
/// C-contiguous numbers of the given type. Throws UsageError "WHAT: numbers are needed, not TYPE".
template <class T>
py::array_t<T, py::array::c_style | py::array::forcecast> to_array(const ArrayLike& given, const std::string& what) {
    using Array = py::array_t<T, py::array::c_style | py::array::forcecast>;
    py::array plain = py::array::ensure(given.object);
    if (!plain)
        PyErr_Clear();
    // A float is no index, and words are no numbers although numpy converts both.
    const char kind = plain ? plain.dtype().kind() : 'O';
    const bool integer = kind == 'i' || kind == 'u' || kind == 'b';
    if (!(integer || (kind == 'f' && std::is_floating_point_v<T>)))
        throw UsageError(what + ": " + (std::is_floating_point_v<T> ? "numbers" : "whole numbers") +
                         " are needed, not " + shape_of(given.object));
    Array array = Array::ensure(plain);
    if (!array) {
        PyErr_Clear();
        throw UsageError(what + ": cannot be converted");
    }
    return array;
}

/// Finite numbers. Throws UsageError.
template <class Vector>
Vector to_vector(const ArrayLike& given, const std::string& what) {
    using Number = typename Vector::value_type;
    const auto array = to_array<Number>(given, what);
    constexpr int length = Vector::length();
    if (array.ndim() != 1 || array.size() != length)
        throw UsageError(what + ": " + std::to_string(length) + " numbers are needed, not shape " + shape_of(array));
    Vector vector{};
    for (int i = 0; i < length; ++i) {
        vector[i] = array.at(i);
        if (!std::isfinite(vector[i]))
            throw UsageError(what + ": not finite");
    }
    return vector;
}

/// Rows as numpy has them; glm keeps columns. Throws UsageError.
template <class Matrix>
Matrix to_matrix(const ArrayLike& given, const std::string& what) {
    const auto array = to_array<double>(given, what);
    constexpr int side = Matrix::length();
    if (array.ndim() != 2 || array.shape(0) != side || array.shape(1) != side)
        throw UsageError(what + ": a " + std::to_string(side) + "x" + std::to_string(side) +
                         " matrix is needed, not shape " + shape_of(array));
    Matrix matrix{0};
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            matrix[column][row] = array.at(row, column);
            if (!std::isfinite(matrix[column][row]))
                throw UsageError(what + ": not finite");
        }
    return matrix;
}

/// So that an assignment to an element, which could not reach the object, is an error.
template <class Array>
Array read_only(Array array) {
    array.attr("flags").attr("writeable") = false;
    return array;
}
template <class Vector>
py::array from_vector(const Vector& vector) {
    using Number = typename Vector::value_type;
    return read_only(py::array_t<Number>(Vector::length(), &vector[0]));
}
template <class Matrix>
py::array from_matrix(const Matrix& matrix) {
    constexpr py::ssize_t side = Matrix::length();
    py::array_t<double> array({side, side});
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            array.mutable_at(row, column) = matrix[column][row];
    return read_only(std::move(array));
}
/// Somebody's memory, which `owner` keeps: not a copy.
template <class T>
py::array view(const T* data, std::vector<py::ssize_t> shape, const py::object& owner) {
    return read_only(py::array_t<T>(std::move(shape), data, owner));
}
/// Keeps a shared object for view().
template <class T>
py::capsule keep(std::shared_ptr<T> object) {
    return py::capsule(new std::shared_ptr<T>(std::move(object)),
                       [](void* held) { delete static_cast<std::shared_ptr<T>*>(held); });
}

/// (height, width, 3) float32, whose base is the Image.
Picture to_picture(Image image);
/// (height, width, 3) uint8: display-encoded values as save_png() rounds them.
Picture to_bytes(const Image& display);

/// A picture of the caller as the library wants it: where it is one of ours the same memory, else a copy.
class GivenPicture {
public:
    /// Throws UsageError "WHAT: …".
    GivenPicture(const PictureLike& given, const std::string& what);
    const Image& image() const { return shown_ ? *shown_ : copy_; }

private:
    py::object keeper_;
    const Image* shown_ = nullptr;
    Image copy_;
};

} // namespace prelight::python

namespace pybind11::detail {
template <>
struct type_caster<prelight::python::ArrayLike> {
    PYBIND11_TYPE_CASTER(prelight::python::ArrayLike, const_name("ArrayLike"));
    bool load(handle source, bool) {
        value.object = reinterpret_borrow<object>(source);
        return true;
    }
    static handle cast(const prelight::python::ArrayLike& given, return_value_policy, handle) {
        return given.object.inc_ref();
    }
};
template <>
struct type_caster<prelight::python::PictureLike> {
    PYBIND11_TYPE_CASTER(prelight::python::PictureLike, const_name("PictureLike"));
    bool load(handle source, bool) {
        value.object = reinterpret_borrow<object>(source);
        return true;
    }
    static handle cast(const prelight::python::PictureLike& given, return_value_policy, handle) {
        return given.object.inc_ref();
    }
};
template <>
struct type_caster<prelight::python::Picture> {
    PYBIND11_TYPE_CASTER(prelight::python::Picture, const_name("Picture"));
    static handle cast(const prelight::python::Picture& picture, return_value_policy, handle) {
        return picture.array.inc_ref();
    }
};
} // namespace pybind11::detail
