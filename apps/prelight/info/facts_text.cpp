#include "scene_facts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <prelight/error.hpp>

namespace prelight::app {
namespace {

using Json = nlohmann::ordered_json;

/// Of a longer list the rest is counted: --json has all.
constexpr size_t most_lines = 20;

/// A name of the file's, which may hold anything: what is one line stays one.
std::string name_of(const Json& text) { return escaped(text.get<std::string>()); }

std::string mega(const Json& bytes) { return fmt::format("{:.1f} MB", bytes.get<double>() / 1e6); }

std::string count_of(uint64_t count, std::string_view what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string words(const Json& list) {
    std::string text;
    for (const Json& one : list)
        text += (text.empty() ? "" : ", ") + name_of(one);
    return text.empty() ? "none" : text;
}

std::string mesh_line(const Json& m) {
    std::string text = fmt::format("{}, {} triangles, {} vertices", count_of(m["primitives"], "primitive"),
                                   m["triangles"].get<uint64_t>(), m["vertices"].get<uint64_t>());
    if (m["skinned"])
        text += ", skinned";
    if (m["morph_targets"] > 0)
        text += ", " + count_of(m["morph_targets"], "morph target");
    return text;
}

std::string material_line(const Json& m) {
    return fmt::format("{}, {}{}{}, textures: {}", name_of(m["shader"]), name_of(m["alpha"]),
                       m["double_sided"] ? ", double-sided" : "", m["emits"] ? ", emits" : "", words(m["textures"]));
}

std::string picture_line(const Json& p) {
    return fmt::format("{}x{}, {} decoded", p["size"][0].get<uint32_t>(), p["size"][1].get<uint32_t>(),
                       mega(p["bytes"]));
}

std::string metres(const Json& value) {
    return value.is_null() ? "without end" : fmt::format("{:.4g} m", value.get<double>());
}

std::string light_line(const Json& l) {
    std::string text = fmt::format("{}, {:.4g} {}, colour {:.3g} {:.3g} {:.3g}", name_of(l["kind"]),
                                   l["intensity"].get<double>(), name_of(l["unit"]), l["colour"][0].get<double>(),
                                   l["colour"][1].get<double>(), l["colour"][2].get<double>());
    if (l["kind"] != "directional")
        text += ", range " + metres(l["range_m"]);
    if (l.contains("outer_cone_degrees"))
        text += fmt::format(", cone {:.3g}° to {:.3g}° from its axis", l["inner_cone_degrees"].get<double>(),
                            l["outer_cone_degrees"].get<double>());
    for (const char* key : {"cookie", "profile"})
        if (l.contains(key))
            text += fmt::format(", {} {}", key, name_of(l[key]));
    return l["placed"] == 1 ? text : text + fmt::format(", on {} nodes", l["placed"].get<uint64_t>());
}

std::string camera_line(const Json& c) {
    const std::string view = c.contains("yfov_degrees") ? fmt::format("{:.4g}° high", c["yfov_degrees"].get<double>())
                                                        : fmt::format("{:.4g} m high", c["height_m"].get<double>());
    return fmt::format("{}, {}, from {} to {}", name_of(c["kind"]), view, metres(c["near_m"]),
                       c["far_m"].is_null() ? "infinity" : metres(c["far_m"]));
}

std::string animation_line(const Json& a) {
    return fmt::format("{:.4g} s, {}, {}", a["seconds"].get<double>(), count_of(a["channels"], "channel"),
                       count_of(a["keyframes"], "keyframe"));
}

std::string skin_line(const Json& s) { return count_of(s["joints"], "joint"); }

std::string extension_line(const Json& e) {
    const std::string honoured = e["honoured"];
    return fmt::format("{}{}: {}: {}", count_of(e["objects"], "object"), e["required"] ? ", required" : "",
                       honoured == "not"     ? "not honoured"
                       : honoured == "whole" ? "honoured"
                                             : "honoured in part",
                       name_of(e["how"]));
}

std::string section(const Json& list, const char* title, const std::function<std::string(const Json&)>& line) {
    if (list.empty())
        return {};
    std::string text = fmt::format("{} ({})\n", title, list.size());
    for (size_t i = 0; i < list.size() && i < most_lines; ++i) {
        const std::string name = name_of(list[i]["name"]);
        text += fmt::format("  {} {}: {}\n", i, name.empty() ? "without a name" : name, line(list[i]));
    }
    if (list.size() > most_lines)
        text += fmt::format("  … and {} more (--json has them all)\n", list.size() - most_lines);
    return text;
}

} // namespace

std::string facts_text(const Json& facts) {
    const Json& world = facts["world"];
    const Json& memory = facts["memory"];
    std::string text = name_of(facts["scene"]);
    text += facts["built_in"] ? ": a built-in scene\n" : fmt::format(": glTF, {}\n", mega(memory["files_bytes"]));
    if (const std::string generator = name_of(facts["generator"]); !generator.empty())
        text += "made by " + generator + "\n";
    text += section(facts["scenes"], "scenes", [&](const Json& s) { return count_of(s["roots"], "root node"); });
    text += fmt::format("shown: scene {}, {}, {} triangles, {}, {}\n", facts["shown"].get<uint32_t>(),
                        count_of(world["instances"], "object"), world["triangles"].get<uint64_t>(),
                        count_of(world["lights"], "light"), count_of(world["decals"], "decal"));
    if (const Json& bounds = world["bounds_m"]; !bounds.is_null()) {
        const auto corner = [&](const char* which) {
            const Json& p = bounds[which];
            return fmt::format("({:.4g}, {:.4g}, {:.4g})", p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
        };
        text += fmt::format("bounds: {} to {} m\n", corner("min"), corner("max"));
    }
    if (!facts["environment"].is_null())
        text += "environment: " + name_of(facts["environment"]) + "\n";
    text += section(facts["meshes"], "meshes", mesh_line);
    text += section(facts["materials"], "materials", material_line);
    text += section(facts["pictures"], "pictures", picture_line);
    text += section(facts["lights"], "lights", light_line);
    text += section(facts["cameras"], "cameras", camera_line);
    text += section(facts["animations"], "animations", animation_line);
    text += section(facts["skins"], "skins", skin_line);
    if (facts["emitters"] > 0)
        text += fmt::format("emitters: {}\n", facts["emitters"].get<uint64_t>());
    text += section(facts["extensions"], "extensions", extension_line);
    text += fmt::format("memory: geometry {}, pictures {}, with mip levels {}\n", mega(memory["geometry_bytes"]),
                        mega(memory["pictures_bytes"]), mega(memory["pictures_with_levels_bytes"]));
    for (const Json& warning : facts["warnings"])
        text += "warning: " + name_of(warning) + "\n";
    return text;
}

} // namespace prelight::app
