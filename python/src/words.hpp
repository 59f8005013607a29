#pragma once
#include "module.hpp"
#include <array>
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>
#include <string>

// Enumerations are enum.StrEnum in Python, so a word serves wherever a member does: Light(kind="spot").
namespace prelight::python {

template <class E>
struct Word {
    E value;
    const char* word;
};
template <class E>
struct Words;

template <>
struct Words<LightKind> {
    static constexpr const char* name = "LightKind";
    static constexpr const char* doc = "What a light is: directional (lux), point or spot (candela).";
    static constexpr std::array<Word<LightKind>, 3> all{
        {{LightKind::directional, "directional"}, {LightKind::point, "point"}, {LightKind::spot, "spot"}}};
};
template <>
struct Words<Falloff> {
    static constexpr const char* name = "Falloff";
    static constexpr const char* doc =
        "How light falls off with the distance d: gltf, clamp(1 - (d/range)^4, 0, 1) / d^2; linear, clamp(1 - d/range, "
        "0, 1); quadratic, clamp(1 - (d/range)^2, 0, 1).";
    static constexpr std::array<Word<Falloff>, 3> all{
        {{Falloff::gltf, "gltf"}, {Falloff::linear, "linear"}, {Falloff::quadratic, "quadratic"}}};
};
template <>
struct Words<ProjectionKind> {
    static constexpr const char* name = "ProjectionKind";
    static constexpr const char* doc = "How a camera projects.";
    static constexpr std::array<Word<ProjectionKind>, 2> all{
        {{ProjectionKind::perspective, "perspective"}, {ProjectionKind::orthographic, "orthographic"}}};
};
template <>
struct Words<AlphaMode> {
    static constexpr const char* name = "AlphaMode";
    static constexpr const char* doc =
        "What alpha means: nothing (opaque), there or not there (mask), how much is let through (blend).";
    static constexpr std::array<Word<AlphaMode>, 3> all{
        {{AlphaMode::opaque, "opaque"}, {AlphaMode::mask, "mask"}, {AlphaMode::blend, "blend"}}};
};
template <>
struct Words<Shading> {
    static constexpr const char* name = "Shading";
    static constexpr const char* doc = "The lighting model: phong (Blinn-Phong) or ggx (glTF's metallic-roughness).";
    static constexpr std::array<Word<Shading>, 2> all{{{Shading::phong, "phong"}, {Shading::ggx, "ggx"}}};
};
template <>
struct Words<Tonemap> {
    static constexpr const char* name = "Tonemap";
    static constexpr const char* doc =
        "From scene-linear to what a display shows: Khronos PBR Neutral, an ACES fit, or a clamp to 0 ... 1.";
    static constexpr std::array<Word<Tonemap>, 3> all{
        {{Tonemap::pbr_neutral, "pbr-neutral"}, {Tonemap::aces, "aces"}, {Tonemap::none, "none"}}};
};

/// The enumeration as Python has it. Never freed.
template <class E>
inline PyObject* word_class = nullptr;

template <class E>
void bind_words(py::module_& module) {
    py::dict members;
    for (const Word<E>& word : Words<E>::all) {
        std::string name = word.word;
        for (char& letter : name)
            letter = letter == '-' ? '_' : char(std::toupper(letter));
        members[py::str(name)] = word.word;
    }
    py::object made =
        py::module_::import("enum").attr("StrEnum")(Words<E>::name, members, py::arg("module") = "prelight");
    made.attr("__doc__") = Words<E>::doc;
    module.attr(Words<E>::name) = made;
    word_class<E> = made.release().ptr();
}

template <class E>
struct WordCaster {
    PYBIND11_TYPE_CASTER(E, py::detail::const_name("str"));
    bool load(py::handle source, bool) {
        if (!PyUnicode_Check(source.ptr()))
            return false;
        const auto asked = source.cast<std::string>();
        std::string known;
        for (const Word<E>& word : Words<E>::all) {
            if (asked == word.word) {
                value = word.value;
                return true;
            }
            known += (known.empty() ? "" : ", ") + std::string(word.word);
        }
        throw UsageError(std::string(Words<E>::name) + ": \"" + asked + "\" is none of " + known);
    }
    static py::handle cast(E member, py::return_value_policy, py::handle) {
        for (const Word<E>& word : Words<E>::all)
            if (word.value == member)
                return py::handle(word_class<E>)(word.word).release();
        throw Error(std::string(Words<E>::name) + ": a member that has no word");
    }
};

} // namespace prelight::python

namespace pybind11::detail {
template <>
struct type_caster<prelight::LightKind> : prelight::python::WordCaster<prelight::LightKind> {};
template <>
struct type_caster<prelight::Falloff> : prelight::python::WordCaster<prelight::Falloff> {};
template <>
struct type_caster<prelight::ProjectionKind> : prelight::python::WordCaster<prelight::ProjectionKind> {};
template <>
struct type_caster<prelight::AlphaMode> : prelight::python::WordCaster<prelight::AlphaMode> {};
template <>
struct type_caster<prelight::Shading> : prelight::python::WordCaster<prelight::Shading> {};
template <>
struct type_caster<prelight::Tonemap> : prelight::python::WordCaster<prelight::Tonemap> {};
} // namespace pybind11::detail
