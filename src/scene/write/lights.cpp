#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numbers>
#include <prelight/light_distribution.hpp>
#include <scene/write/parts.hpp>

namespace prelight::write {
namespace {

/// KHR_lights_punctual keeps colours within 0 … 1: what is above goes to the intensity, as a power
/// of two so that nothing is rounded.
void set_colour(Json& entry, const Light& light) {
    const float largest = std::max({light.colour.r, light.colour.g, light.colour.b});
    float factor = 1;
    while (largest > factor)
        factor *= 2;
    if (light.colour != glm::vec3(1))
        entry["color"] = numbers(light.colour / factor);
    if (light.intensity * factor != 1)
        entry["intensity"] = number(light.intensity * factor);
}

void set_cone(Json& entry, const Light& light) {
    // The float nearest to π/2 lies above it, and the extension's limit does not.
    const double outer = std::min(number(light.outer_cone).get<double>(), std::numbers::pi / 2);
    double inner = number(light.inner_cone).get<double>();
    if (inner >= outer) // the extension wants the inner cone smaller, by however little
        inner = std::nextafter(static_cast<float>(outer), 0.0f);
    entry["spot"] = {{"innerConeAngle", inner}, {"outerConeAngle", outer}};
}

void set_extras(Json& entry, const Light& light) {
    if (light.falloff != Falloff::gltf && light.kind != LightKind::directional)
        entry["extras"]["prelight"]["falloff"] = light.falloff == Falloff::linear ? "linear" : "quadratic";
    if (light.shininess != 1)
        entry["extras"]["prelight"]["shininess"] = number(light.shininess);
    if (!light.casts_shadow)
        entry["extras"]["prelight"]["castsShadow"] = false;
    if (light.size != Light().size)
        entry["extras"]["prelight"]["size"] = number(light.size);
}

/// Pictures as textures, profiles as they were read in the binary chunk; each once.
class Distributions {
public:
    explicit Distributions(Document& document) : document_(document) {}

    void write(Json& entry, const Light& light) {
        if (light.cookie != no_cookie) {
            const auto [texture, is_new] = textures_.try_emplace(light.cookie);
            if (is_new)
                texture->second = document_.add("textures", {{"source", light.cookie}});
            entry["extras"]["prelight"]["cookie"] = {{"texture", {{"index", texture->second}}}};
        }
        if (!light.profile)
            return;
        const auto [view, is_new] = views_.try_emplace(light.profile.get());
        if (is_new)
            view->second = document_.add_view(std::as_bytes(std::span(light.profile->text)), ViewKind::other);
        entry["extras"]["prelight"]["ies"] = {{"bufferView", view->second}};
        if (light.profile_candela)
            entry["extras"]["prelight"]["ies"]["candela"] = true;
    }

private:
    Document& document_;
    std::map<uint32_t, uint32_t> textures_;
    std::map<const LightProfile*, uint32_t> views_;
};

void check(const Scene& scene, const Light& light, size_t index, const Document& document) {
    check_light(scene, light, fmt::format("{}: {}", document.name(), label("light", index, light.name)));
    const float sum = light.colour.r + light.colour.g + light.colour.b + light.intensity + light.inner_cone +
                      light.outer_cone + light.shininess;
    const bool positive = std::min({light.colour.r, light.colour.g, light.colour.b}) >= 0 && light.intensity >= 0 &&
                          light.range > 0 && light.outer_cone > 0 && light.shininess > 0;
    if (!std::isfinite(sum) || !std::isfinite(light.intensity * light.colour.r) || !positive)
        document.fail(label("light", index, light.name), "a value is out of range");
    if (light.falloff != Falloff::gltf && light.kind != LightKind::directional && !std::isfinite(light.range))
        document.fail(label("light", index, light.name), "its falloff needs a range");
}

} // namespace

void add_lights(const Scene& scene, Document& document) {
    if (scene.lights.empty())
        return;
    document.use("KHR_lights_punctual");
    Json& lights = document.root["extensions"]["KHR_lights_punctual"]["lights"];
    Distributions distributions(document);
    for (size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        check(scene, light, i, document);
        Json entry = Json::object();
        set_name(entry, light.name);
        entry["type"] = light.kind == LightKind::directional ? "directional"
                        : light.kind == LightKind::point     ? "point"
                                                             : "spot";
        set_colour(entry, light);
        if (light.kind != LightKind::directional && std::isfinite(light.range))
            entry["range"] = number(light.range);
        if (light.kind == LightKind::spot)
            set_cone(entry, light);
        set_extras(entry, light);
        distributions.write(entry, light);
        lights.push_back(std::move(entry));
    }
}

} // namespace prelight::write
