#include <algorithm>
#include <cmath>
#include <scene/write/node_extras.hpp>

namespace prelight::write {
namespace {

Json decal_entry(const Decal& decal) {
    const Decal plain;
    Json entry = {{"material", decal.material}};
    if (decal.opacity != plain.opacity)
        entry["opacity"] = number(decal.opacity);
    if (decal.order != plain.order)
        entry["order"] = decal.order;
    if (decal.fade_from != plain.fade_from || decal.fade_to != plain.fade_to)
        entry["fade"] = {number(decal.fade_from), number(decal.fade_to)};
    if (decal.colour && decal.normal && decal.roughness)
        return entry;
    entry["channels"] = Json::array();
    for (const auto& [name, on] :
         {std::pair("colour", decal.colour), {"normal", decal.normal}, {"roughness", decal.roughness}})
        if (on)
            entry["channels"].push_back(name);
    return entry;
}

Json emitter_entry(const Emitter& e) {
    Json entry = {{"count", e.count},
                  {"seed", e.seed},
                  {"lifetime", {number(e.lifetime_from), number(e.lifetime_to)}},
                  {"speed", {number(e.speed_from), number(e.speed_to)}},
                  {"cone", number(e.cone)},
                  {"radius", number(e.radius)},
                  {"gravity", number(e.gravity)},
                  {"drag", number(e.drag)}};
    if (e.ground)
        entry["ground"] = number(*e.ground);
    entry["bounce"] = number(e.bounce);
    entry["slip"] = number(e.slip);
    for (const glm::vec3& colour : e.colours)
        entry["colours"].push_back(numbers(colour));
    entry["intensity"] = number(e.intensity);
    entry["range"] = number(e.range);
    entry["size"] = number(e.size);
    entry["streak"] = number(e.streak);
    if (e.size > 0)
        entry["material"] = e.material;
    if (e.casts_shadow)
        entry["castsShadow"] = true;
    if (!e.lights)
        entry["lights"] = false;
    if (e.shape == ParticleShape::billboard)
        entry["shape"] = "billboard";
    const auto steps = [&](const char* key, const std::vector<float>& values) {
        if (values == std::vector<float>{1})
            return;
        for (const float value : values)
            entry[key].push_back(number(value));
    };
    steps("sizes", e.sizes);
    steps("opacities", e.opacities);
    if (e.spin > 0)
        entry["spin"] = number(e.spin);
    return entry;
}

bool emitter_is_finite(const Emitter& e) {
    float sum = e.lifetime_to + e.speed_to + e.cone + e.radius + e.gravity + e.drag + e.ground.value_or(0) + e.bounce +
                e.slip + e.intensity + e.range + e.size + e.streak + e.spin;
    for (const std::vector<float>& values : {e.sizes, e.opacities})
        for (const float value : values)
            sum += value;
    for (const glm::vec3& colour : e.colours)
        sum += colour.r + colour.g + colour.b;
    return std::isfinite(sum) && !e.colours.empty() && !e.sizes.empty() && !e.opacities.empty();
}

} // namespace

void set_node_extras(Json& entry, const Scene& scene, const Node& node, const std::string& object,
                     const Document& document) {
    if (!node.receives_decals)
        entry["extras"]["prelight"]["receivesDecals"] = false;
    if (node.decal) {
        const Decal& decal = scene.decals.at(*node.decal);
        if (!std::isfinite(decal.opacity + decal.fade_from + decal.fade_to))
            document.fail(object, "its decal holds a number that is not finite");
        entry["extras"]["prelight"]["decal"] = decal_entry(decal);
    }
    if (node.emitter) {
        const Emitter& emitter = scene.emitters.at(*node.emitter);
        if (!emitter_is_finite(emitter))
            document.fail(object, "its emitter holds a number that is not finite, or no colour");
        entry["extras"]["prelight"]["emitter"] = emitter_entry(emitter);
    }
}

} // namespace prelight::write
