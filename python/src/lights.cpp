#include "boxes.hpp"
#include "words.hpp"
#include <numbers>
#include <prelight/light_distribution.hpp>
#include <pybind11/stl/filesystem.h>

namespace prelight::python {
namespace {

using LightEntry = Entry<PlacedLight>;

/// What is wrong with its numbers; null: nothing.
const char* number_fault(const PlacedLight& placed) {
    const Light& light = placed.light;
    const auto finite = [](const auto& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
    if (!finite(light.colour) || light.colour.x < 0 || light.colour.y < 0 || light.colour.z < 0)
        return "colour is not three finite numbers of 0 or more";
    if (!(light.intensity >= 0 && std::isfinite(light.intensity)))
        return "intensity is not a finite number of 0 or more";
    if (!(light.range > 0))
        return "range is not above 0";
    if (light.falloff != Falloff::gltf && !std::isfinite(light.range))
        return "this falloff needs a finite range";
    constexpr float quarter = std::numbers::pi_v<float> / 2;
    if (light.kind == LightKind::spot && !(light.inner_cone >= 0 && light.inner_cone <= light.outer_cone))
        return "inner_cone is not between 0 and outer_cone";
    if (light.kind == LightKind::spot && !(light.outer_cone > 0 && light.outer_cone <= quarter + 1e-5f))
        return "outer_cone is not above 0 and at most pi/2";
    if (!(light.shininess > 0 && std::isfinite(light.shininess)))
        return "shininess is not a finite number above 0";
    if (!(light.size >= 0 && std::isfinite(light.size)))
        return "size is not a finite number of 0 or more";
    if (!(std::abs(glm::dot(placed.direction, placed.direction) - 1) < 1e-4))
        return "direction is not of unit length";
    return nullptr;
}

glm::dvec3 unit(const ArrayLike& given, const char* what) {
    const auto vector = to_vector<glm::dvec3>(given, what);
    const double length = glm::length(vector);
    if (!(length > 0 && std::isfinite(length)))
        throw UsageError(std::string(what) + ": has no direction");
    return vector / length;
}

py::str light_repr(const LightEntry& entry) {
    const PlacedLight& p = entry.get();
    return py::str("Light({!r}, position=({:.6g}, {:.6g}, {:.6g}), colour=({:.4g}, {:.4g}, {:.4g}), intensity={:.6g}, "
                   "range={:.6g})")
        .format(py::cast(p.light.kind).attr("value"), p.position.x, p.position.y, p.position.z, p.light.colour.x,
                p.light.colour.y, p.light.colour.z, p.light.intensity, p.light.range);
}

/// A column of the list as an array: (lights, N), or (lights,) of a single number.
template <class Get>
void column(py::class_<Entries<PlacedLight>>& list, const char* name, Get get, const char* doc) {
    using Member = std::decay_t<decltype(get(std::declval<PlacedLight&>()))>;
    constexpr bool single = std::is_arithmetic_v<Member>;
    using Number =
        std::conditional_t<single, float, std::conditional_t<std::is_same_v<Member, glm::dvec3>, double, float>>;
    list.def_property(
        name,
        [get](const Entries<PlacedLight>& entries) -> py::array {
            const std::vector<PlacedLight>& lights = entries.get();
            std::vector<py::ssize_t> shape{py::ssize_t(lights.size())};
            if (!single)
                shape.push_back(3);
            py::array_t<Number> array(shape);
            Number* to = array.mutable_data();
            for (const PlacedLight& light : lights)
                if constexpr (single)
                    *to++ = get(light);
                else
                    for (int i = 0; i < 3; ++i)
                        *to++ = get(light)[i];
            return read_only(std::move(array));
        },
        [get, name](Entries<PlacedLight>& entries, const ArrayLike& given) {
            const auto array = to_array<Number>(given, name);
            std::vector<PlacedLight>& lights = entries.edit();
            const auto count = py::ssize_t(lights.size());
            if (array.ndim() != (single ? 1 : 2) || array.shape(0) != count || (!single && array.shape(1) != 3))
                throw UsageError(std::string(name) + ": an array of shape (" + std::to_string(count) +
                                 (single ? ",)" : ", 3)") + " is needed, not " + shape_of(array));
            const Number* from = array.data();
            for (PlacedLight& light : lights)
                if constexpr (single) {
                    get(light) = *from++;
                } else {
                    for (int i = 0; i < 3; ++i)
                        get(light)[i] = *from++;
                }
        },
        doc);
}

void bind_light_list(py::module_& module) {
    auto list = bind_editable_entries<PlacedLight>(module, "LightList",
                                                   "The lights of a world: a list, and its numbers as arrays. Those "
                                                   "are copies: assign a whole array to change them.");
    column(
        list, "positions", [](auto& p) -> auto& { return p.position; }, "(lights, 3) float64, world, metres.");
    column(
        list, "directions", [](auto& p) -> auto& { return p.direction; },
        "(lights, 3) float64, world, of unit length: the way each shines.");
    column(
        list, "colours", [](auto& p) -> auto& { return p.light.colour; }, "(lights, 3) float32, linear RGB.");
    column(
        list, "intensities", [](auto& p) -> auto& { return p.light.intensity; },
        "(lights,) float32, candela or (directional) lux.");
    column(
        list, "ranges", [](auto& p) -> auto& { return p.light.range; }, "(lights,) float32, metres.");
}

} // namespace

void check_lights_given(const Scene& scene, const std::vector<PlacedLight>& lights) {
    for (size_t i = 0; i < lights.size(); ++i) {
        const glm::dvec3& p = lights[i].position;
        const char* fault = number_fault(lights[i]);
        if (!fault && !(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)))
            fault = "position is not finite";
        if (fault)
            throw UsageError("lights[" + std::to_string(i) + "] \"" + lights[i].light.name + "\": " + fault);
    }
    check_lights(scene, lights);
}

void bind_lights(py::module_& module) {
    py::class_<LightEntry> light(
        module, "Light",
        "A light in the world. It falls off as glTF's do: clamp(1 - (d/range)^4, 0, 1) / d^2. Out-of-range values are "
        "refused where the light is used.");
    light.def(py::init([](LightKind kind, const ArrayLike& position, const ArrayLike& direction,
                          const ArrayLike& colour, float intensity, float range, float inner_cone, float outer_cone,
                          float shininess, Falloff falloff, bool casts_shadow, float size, std::string name) {
                  return LightEntry(PlacedLight{.light = {.name = std::move(name),
                                                          .kind = kind,
                                                          .colour = to_vector<glm::vec3>(colour, "colour"),
                                                          .intensity = intensity,
                                                          .range = range,
                                                          .inner_cone = inner_cone,
                                                          .outer_cone = outer_cone,
                                                          .shininess = shininess,
                                                          .falloff = falloff,
                                                          .casts_shadow = casts_shadow,
                                                          .size = size},
                                                .position = to_vector<glm::dvec3>(position, "position"),
                                                .direction = unit(direction, "direction")});
              }),
              py::arg("kind") = LightKind::point, py::kw_only(),
              py::arg("position") = ArrayLike{py::make_tuple(0, 0, 0)},
              py::arg("direction") = ArrayLike{py::make_tuple(0, 0, -1)},
              py::arg("colour") = ArrayLike{py::make_tuple(1, 1, 1)}, py::arg("intensity") = 1.0f,
              py::arg("range") = std::numeric_limits<float>::infinity(), py::arg("inner_cone") = 0.0f,
              py::arg("outer_cone") = 0.785398163f, py::arg("shininess") = 1.0f, py::arg("falloff") = Falloff::gltf,
              py::arg("casts_shadow") = true, py::arg("size") = 0.03f, py::arg("name") = "");
    field(
        light, "name", [](auto& p) -> auto& { return p.light.name; }, "For messages.");
    field(
        light, "kind", [](auto& p) -> auto& { return p.light.kind; }, "directional, point or spot.");
    vector_field(
        light, "position", [](auto& p) -> auto& { return p.position; }, "(3,) float64, world, metres.");
    light.def_property(
        "direction", [](const LightEntry& entry) { return from_vector(entry.get().direction); },
        [](LightEntry& entry, const ArrayLike& given) {
            const glm::dvec3 direction = unit(given, "direction");
            entry.edit().direction = direction;
        },
        "(3,) float64, world: the way it shines. Made unit length.");
    vector_field(
        light, "up", [](auto& p) -> auto& { return p.up; }, "(3,) float64, world: up in its profile or cookie.");
    vector_field(
        light, "colour", [](auto& p) -> auto& { return p.light.colour; }, "(3,) float32, linear RGB, each 0 or more.");
    field(
        light, "intensity", [](auto& p) -> auto& { return p.light.intensity; },
        "Candela (point, spot) or lux (directional), 0 or more.");
    field(
        light, "range", [](auto& p) -> auto& { return p.light.range; },
        "Metres, above 0; infinite: it reaches everything.");
    field(
        light, "inner_cone", [](auto& p) -> auto& { return p.light.inner_cone; }, "Radians from the axis, spots only.");
    field(
        light, "outer_cone", [](auto& p) -> auto& { return p.light.outer_cone; },
        "Radians from the axis, up to pi/2, spots only.");
    field(
        light, "shininess", [](auto& p) -> auto& { return p.light.shininess; },
        "With shading phong: multiplies the material's exponent.");
    field(
        light, "falloff", [](auto& p) -> auto& { return p.light.falloff; },
        "gltf, linear or quadratic; the last two need a finite range.");
    field(
        light, "casts_shadow", [](auto& p) -> auto& { return p.light.casts_shadow; },
        "Where a renderer draws shadows at all (setting shadows).");
    field(
        light, "size", [](auto& p) -> auto& { return p.light.size; },
        "Metres: radius of the sphere that soft shadows take it for.");
    light.def(
        "set_profile",
        [](LightEntry& entry, const std::filesystem::path& path, bool candela) {
            auto profile = without_gil([&] { return std::make_shared<const LightProfile>(load_profile(path)); });
            Light& edited = entry.edit().light;
            edited.profile = std::move(profile);
            edited.profile_candela = candela;
        },
        py::arg("path"), py::arg("candela") = false,
        "Lets it shine as an IES file (LM-63) says. candela: intensity is a factor on the file's candela, and not the "
        "profile's maximum. Raises Error.");
    light.def("__repr__", &light_repr);
    bind_light_list(module);
}

} // namespace prelight::python
