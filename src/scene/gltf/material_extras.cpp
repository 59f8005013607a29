#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/material_shader.hpp>
#include <scene/gltf/extras.hpp>
#include <scene/gltf/textures.hpp>

namespace prelight::gltf {
namespace {

using simdjson::dom::element;

/// A number, or an array of up to four; nothing, with a warning, for anything else.
std::optional<glm::vec4> read_value(const Item& own, std::string_view key, const element& value) {
    bool good = true;
    const auto number = [&](const element& e) {
        double v = 0;
        good = good && !e.get_double().get(v) && std::isfinite(static_cast<float>(v));
        return static_cast<float>(v);
    };
    glm::vec4 out(0);
    simdjson::dom::array list;
    int count = 1;
    if (value.get_array().get(list))
        out.x = number(value);
    else {
        count = 0;
        for (const element& e : list)
            if (count++ < 4)
                out[count - 1] = number(e);
    }
    if (good && count >= 1 && count <= 4)
        return out;
    own.warn("parameter {} is neither a number nor an array of 1 to 4; its default is used", printable(key));
    return {};
}

/// The members of an object of ours; none when it is absent.
simdjson::dom::object members(const Item& own, std::string_view key, bool& there) {
    simdjson::dom::object object;
    const auto found = own.find(key);
    there = found.has_value();
    if (found && found->get_object().get(object)) {
        own.warn("{} is not an object; it is ignored", key);
        there = false;
    }
    return object;
}

} // namespace

void read_material_extras(Textures& textures, const Item& item, Material& material) {
    const auto own = own_extras(item);
    if (!own)
        return;
    material.receives_decals = own->flag("receivesDecals", true);
    const double softness = own->number("softness", 0);
    if (softness >= 0 && std::isfinite(static_cast<float>(softness)))
        material.softness = static_cast<float>(softness);
    else
        own->warn("softness is {}, and not metres ≥ 0; it is ignored", softness);
    bool there = false;
    const simdjson::dom::object parameters = members(*own, "parameters", there);
    if (there)
        for (const auto& [key, value] : parameters)
            if (const auto read = read_value(*own, key, value))
                material.parameters[std::string(key)] = *read;
    const simdjson::dom::object maps = members(*own, "textures", there);
    if (there) {
        const Item list = *own->object("textures");
        for (const auto& [key, value] : maps)
            material.textures[std::string(key)] = textures.read(list, key);
    }
    const std::string name = own->text("material");
    if (name.empty())
        return; // they are for a file that is named elsewhere
    material.shader = find_material_shader(name);
    if (!material.shader) {
        std::vector<std::string_view> known;
        for (const auto& shader : built_in_material_shaders())
            known.push_back(shader->name);
        own->warn("material \"{}\" is not built in ({}); glTF's own is drawn", printable(name), fmt::join(known, ", "));
    }
    if (const auto fault = material_fault(material)) {
        item.warn("{}; glTF's own is drawn", *fault);
        material.shader.reset();
        material.parameters.clear();
        material.textures.clear();
    }
}

} // namespace prelight::gltf
