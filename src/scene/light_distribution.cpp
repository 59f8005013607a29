#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <prelight/error.hpp>
#include <prelight/light_distribution.hpp>
#include <scene/place_camera.hpp>

namespace prelight {

CookieKind cookie_kind(const Scene& scene, const Light& light) {
    if (light.cookie == no_cookie)
        return CookieKind::none;
    if (light.kind == LightKind::spot)
        return CookieKind::spot;
    const TextureImage& image = scene.images.at(light.cookie);
    return image.width == 2 * image.height ? CookieKind::sphere : CookieKind::cube;
}

std::optional<std::string> light_fault(const Scene& scene, const Light& light) {
    if (!(light.size > 0) || !std::isfinite(light.size))
        return fmt::format("size {} is no radius above 0", light.size);
    const bool directional = light.kind == LightKind::directional;
    if (light.profile && directional)
        return "a directional light has no profile (ies): points and spots do";
    if (light.cookie == no_cookie)
        return {};
    if (directional)
        return "a directional light has no cookie: points and spots do";
    if (light.cookie >= scene.images.size())
        return fmt::format("cookie: there is no image {}", light.cookie);
    const TextureImage& image = scene.images[light.cookie];
    const uint64_t width = image.width, height = image.height;
    if (width == 0 || height == 0 || image.rgba.size() != width * height * 4)
        return fmt::format("cookie: image {} has no pixels", light.cookie);
    if (light.kind == LightKind::point && width != 2 * height && width != 6 * height)
        return fmt::format(
            "cookie: image {} of {}x{} pixels is neither 2:1 (equirectangular) nor 6:1 (faces of a cube), as a "
            "point light's is",
            light.cookie, width, height);
    if (light.kind == LightKind::spot && light.outer_cone > widest_cookie_cone)
        return fmt::format("cookie: an outer cone of {:.1f}° is wider than a picture can be thrown (85°)",
                           light.outer_cone * 57.29577951308232);
    return {};
}

void check_light(const Scene& scene, const Light& light, const std::string& object) {
    if (const auto fault = light_fault(scene, light))
        throw Error(fmt::format("{}: {}", object, *fault));
}

void check_lights(const Scene& scene, std::span<const PlacedLight> lights) {
    for (const PlacedLight& placed : lights) // every frame may bring 65,536, and few have anything to check
        if (const Light& light = placed.light; has_distribution(light) || !(light.size > 0) || std::isinf(light.size))
            check_light(scene, light, fmt::format("{}: light {}", scene.name, light.name));
}

double largest_intensity(const Light& light) {
    return double(light.intensity) * (light.profile && light.profile_candela ? light.profile->largest : 1.0);
}

glm::dmat3 light_axes(const PlacedLight& light) {
    const glm::dvec3 back = unit_or(-light.direction, {0, 0, 1});
    glm::dvec3 up = light.up - back * glm::dot(light.up, back);
    if (!(glm::dot(up, up) > 1e-18 * glm::dot(light.up, light.up))) // along the way it shines: any will do
        up = glm::cross(back, std::abs(back.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    up = unit_or(up, {0, 1, 0});
    return {glm::cross(up, back), up, back};
}

} // namespace prelight
