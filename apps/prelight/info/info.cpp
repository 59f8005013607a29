// `prelight info`: what is in a scene, without drawing it.
#include "../commands.hpp"
#include "../scene_source.hpp"
#include "../stats_json.hpp"
#include "scene_facts.hpp"

#include <fmt/format.h>
#include <limits>

namespace prelight::app {

void run(const InfoCommand& command) {
    SceneTime time{.moment = {}, .animation = {}, .reading = command.reading};
    time.reading.log_level = LogLevel::error; // warnings are part of what is told
    const auto loaded =
        load_scene(command.scene, command.lights, command.seed, std::numeric_limits<uint32_t>::max(), time);
    const nlohmann::ordered_json facts = scene_facts(command, loaded->scene, loaded->world);
    fmt::print("{}", command.json ? json_text(facts) : facts_text(facts));
}

} // namespace prelight::app
