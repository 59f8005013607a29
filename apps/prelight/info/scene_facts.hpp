#pragma once
#include "command_line.hpp"

#include <nlohmann/json.hpp>
#include <prelight/scene.hpp>

namespace prelight::app {

/// What `prelight info --json` prints; docs/gltf.md describes it. `world` is made of the scene.
nlohmann::ordered_json scene_facts(const InfoCommand& command, const Scene& scene, const World& world);

/// The same for people.
std::string facts_text(const nlohmann::ordered_json& facts);

} // namespace prelight::app
