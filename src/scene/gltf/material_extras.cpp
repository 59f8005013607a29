#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/material_shader.hpp>
#include <scene/gltf/extras.hpp>
#include <scene/gltf/textures.hpp>

namespace prelight::gltf {
namespace {

using simdjson::dom::element;

/// A number, or an array of up to four.
glm::vec4 read_value(const Item& own, std::string_view key, const element& value) {
    const auto bad = [&] {
        own.fail(fmt::format("parameter {} is neither a number nor an array of 1 to 4", printable(key)));
    };
    const auto number = [&](const element& e) {
        double v = 0;
        if (e.get_double().get(v) || !std::isfinite(static_cast<float>(v)))
            bad();
        return static_cast<float>(v);
    };
    glm::vec4 out(0);
    simdjson::dom::array list;
    if (value.get_array().get(list)) {
        out.x = number(value);
        return out;
    }
    int count = 0;
    for (const element& e : list) {
        if (count == 4)
            bad();
        out[count++] = number(e);
    }
    if (count == 0)
        bad();
    return out;
}

/// The members of an object of ours; none when it is absent.
simdjson::dom::object members(const Item& own, std::string_view key, bool& there) {
    simdjson::dom::object object;
    const auto found = own.find(key);
    there = found.has_value();
    if (found && found->get_object().get(object))
        own.fail(fmt::format("{} is not an object", key));
    return object;
}

} // namespace

void read_material_extras(Textures& textures, const Item& item, Material& material) {
    const auto own = own_extras(item);
    if (!own)
        return;
    material.receives_decals = own->flag("receivesDecals", true);
    bool there = false;
    const simdjson::dom::object parameters = members(*own, "parameters", there);
    if (there)
        for (const auto& [key, value] : parameters)
            material.parameters[std::string(key)] = read_value(*own, key, value);
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
        own->fail(fmt::format("material \"{}\" is not built in ({})", printable(name), fmt::join(known, ", ")));
    }
    check_material(material, fmt::format("{}: {}", item.file(), item.label()));
}

} // namespace prelight::gltf
