#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <scene/gltf/nodes.hpp>

namespace prelight::gltf {
namespace {

Camera read_camera(const Item& item) {
    Camera camera;
    camera.name = item.text("name");
    const std::string type = item.text("type");
    const auto inner = item.object(type == "orthographic" ? "orthographic" : "perspective");
    if ((type != "perspective" && type != "orthographic") || !inner)
        item.fail(fmt::format("type \"{}\" is not known or has no values", printable(type)));
    camera.znear = inner->number("znear", -1);
    camera.zfar = inner->number("zfar", std::numeric_limits<double>::infinity());
    if (type == "perspective") {
        camera.yfov = inner->number("yfov", 0);
        if (!(camera.yfov > 0 && camera.yfov < std::numbers::pi))
            inner->fail(fmt::format("yfov {} is not 0 … π", camera.yfov));
        if (!(camera.znear > 0))
            inner->fail("znear is not above 0");
    } else {
        camera.kind = ProjectionKind::orthographic;
        camera.ymag = std::abs(inner->number("ymag", 0)); // negative ones only turn the picture
        if (!(camera.ymag > 0))
            inner->fail("ymag is 0");
        if (!(camera.znear >= 0) || !inner->has("zfar"))
            inner->fail("znear or zfar is missing or negative");
    }
    if (!(camera.zfar > camera.znear))
        inner->fail(fmt::format("zfar {} is not beyond znear {}", camera.zfar, camera.znear));
    return camera;
}

void read_cone(const Item& item, Light& light) {
    const auto spot = item.object("spot");
    if (!spot)
        return;
    constexpr double quarter = std::numbers::pi / 4, half = std::numbers::pi / 2;
    const double inner = spot->number("innerConeAngle", 0);
    const double outer = spot->number("outerConeAngle", quarter);
    // A little beyond π/2 is a rounded π/2.
    if (!(inner >= 0 && inner < outer && outer <= half + 1e-5))
        spot->fail(
            fmt::format("cone angles {} and {} are not 0 ≤ inner < outer ≤ π/2", inner, outer));
    light.inner_cone = float(inner);
    light.outer_cone = float(std::min(outer, half));
    if (!(light.inner_cone < light.outer_cone)) // equal only after rounding
        light.inner_cone = std::nextafter(light.outer_cone, 0.f);
}

Light read_light(const Item& item) {
    Light light;
    light.name = item.text("name");
    const std::string type = item.text("type");
    if (type == "directional")
        light.kind = LightKind::directional;
    else if (type == "spot")
        light.kind = LightKind::spot;
    else if (type != "point")
        item.fail(fmt::format("type \"{}\" is not known", printable(type)));
    const auto colour = item.numbers<3>("color", {1, 1, 1});
    for (int c = 0; c < 3; ++c) {
        light.colour[c] = float(colour[size_t(c)]);
        if (!(light.colour[c] >= 0) || !std::isfinite(light.colour[c]))
            item.fail("color is negative or too large");
    }
    light.intensity = item.real("intensity", 1);
    if (!(light.intensity >= 0))
        item.fail("intensity is negative");
    if (item.has("range") && light.kind != LightKind::directional) {
        light.range = item.real("range", 0);
        if (!(light.range > 0))
            item.fail("range is not above 0");
    }
    if (light.kind == LightKind::spot)
        read_cone(item, light);
    return light;
}

} // namespace

void read_cameras(const Document& document, Scene& scene) {
    for (size_t i = 0; i < document.count(Table::cameras); ++i)
        scene.cameras.push_back(read_camera(document.item(Table::cameras, i)));
}

void read_lights(const Document& document, Scene& scene) {
    for (size_t i = 0; i < document.count(Table::lights); ++i)
        scene.lights.push_back(read_light(document.item(Table::lights, i)));
}

} // namespace prelight::gltf
