#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <scene/gltf/nodes.hpp>

namespace prelight::gltf {
namespace {

/// Nothing, with a warning, where there is no telling what it should show.
std::optional<Camera> read_camera(const Item& item) {
    Camera camera;
    camera.name = item.text("name");
    const std::string type = item.text("type");
    const bool perspective = type == "perspective";
    const auto inner = perspective || type == "orthographic" ? item.object(type) : std::nullopt;
    if (!inner) {
        item.warn("type \"{}\" is not known or has no values; the camera is left out", printable(type));
        return {};
    }
    camera.znear = inner->number("znear", -1);
    camera.zfar = inner->number("zfar", std::numeric_limits<double>::infinity());
    if (perspective) {
        camera.yfov = inner->number("yfov", 0);
        if (!(camera.yfov > 0 && camera.yfov < std::numbers::pi)) {
            inner->warn("yfov {} is not 0 … π; the camera is left out", camera.yfov);
            return {};
        }
    } else {
        camera.kind = ProjectionKind::orthographic;
        camera.ymag = std::abs(inner->number("ymag", 0)); // negative ones only turn the picture
        if (!(camera.ymag > 0) || !inner->has("zfar")) {
            inner->warn("ymag is 0 or zfar is missing; the camera is left out");
            return {};
        }
    }
    if (!(perspective ? camera.znear > 0 : camera.znear >= 0)) {
        inner->warn("znear {} is not {}; the camera is left out", camera.znear, perspective ? "above 0" : "at least 0");
        return {};
    }
    if (!(camera.zfar > camera.znear)) {
        inner->warn("zfar {} is not beyond znear {}; {}", camera.zfar, camera.znear,
                    perspective ? "the camera sees without end" : "the camera is left out");
        if (!perspective)
            return {};
        camera.zfar = std::numeric_limits<double>::infinity();
    }
    return camera;
}

void read_cone(const Item& item, Light& light) {
    const auto spot = item.object("spot");
    if (!spot)
        return;
    constexpr double quarter = std::numbers::pi / 4, half = std::numbers::pi / 2;
    double inner = spot->number("innerConeAngle", 0);
    double outer = spot->number("outerConeAngle", quarter);
    if (outer > half + 1e-5) { // a little beyond π/2 is a rounded π/2
        spot->warn("outerConeAngle {} is beyond π/2; π/2 is used", outer);
        outer = half;
    } else if (!(outer > 0)) {
        spot->warn("outerConeAngle {} is not above 0; π/4 is used", outer);
        outer = quarter;
    }
    if (inner < 0) {
        spot->warn("innerConeAngle {} is below 0; 0 is used", inner);
        inner = 0;
    } else if (inner >= outer) {
        spot->warn("innerConeAngle {} is not below outerConeAngle {}; the cone has a hard edge", inner, outer);
    }
    light.outer_cone = float(std::min(outer, half));
    light.inner_cone = std::min(float(inner), std::nextafter(light.outer_cone, 0.f));
}

/// Nothing, with a warning, for a light that lights nothing as far as this reader knows.
std::optional<Light> read_light(const Item& item) {
    Light light;
    light.name = item.text("name");
    const std::string type = item.text("type");
    if (type == "directional")
        light.kind = LightKind::directional;
    else if (type == "spot")
        light.kind = LightKind::spot;
    else if (type != "point") {
        item.warn("type \"{}\" is not known; the light is left out", printable(type));
        return {};
    }
    const auto colour = item.numbers<3>("color", {1, 1, 1});
    for (int c = 0; c < 3; ++c) {
        light.colour[c] = float(colour[size_t(c)]);
        if (light.colour[c] >= 0 && std::isfinite(light.colour[c]))
            continue;
        item.warn("color holds {}, which is negative or too large; {} is used", colour[size_t(c)],
                  colour[size_t(c)] < 0 ? 0 : 1);
        light.colour[c] = light.colour[c] < 0 ? 0.f : 1.f;
    }
    light.intensity = item.real("intensity", 1);
    if (!(light.intensity >= 0)) {
        item.warn("intensity {} is negative; the light is left out", light.intensity);
        return {};
    }
    if (item.has("range") && light.kind != LightKind::directional) {
        constexpr float endless = std::numeric_limits<float>::infinity();
        light.range = item.real("range", endless);
        if (!(light.range > 0)) { // older exporters of three.js write 0 for "no limit"
            item.warn("range {} is not above 0; the light reaches without limit", light.range);
            light.range = endless;
        }
    }
    if (light.kind == LightKind::spot)
        read_cone(item, light);
    return light;
}

/// `read` for each of the file's; which of them stands where.
template <class T, class Read>
Places read_table(const Document& document, Table table, std::vector<T>& out, Read read) {
    Places places;
    for (size_t i = 0; i < document.count(table); ++i) {
        std::optional<T> one = read(document.item(table, i));
        places.push_back(one ? std::optional(uint32_t(out.size())) : std::nullopt);
        if (one)
            out.push_back(std::move(*one));
    }
    return places;
}

} // namespace

Places read_cameras(const Document& document, Scene& scene) {
    return read_table(document, Table::cameras, scene.cameras, read_camera);
}

Places read_lights(const Document& document, Scene& scene) {
    return read_table(document, Table::lights, scene.lights, read_light);
}

} // namespace prelight::gltf
