#include "scene_reading.hpp"

#include "argument.hpp"
#include "options/given.hpp"

namespace prelight::app {

SceneReading parse_reading(const Given& given) {
    SceneReading reading{.scene = given.text("--scene"),
                         .strict = given.has("--strict"),
                         .log_level = given.has("--quiet") ? LogLevel::warning : LogLevel::info,
                         .memory_limit = parse_memory("--memory-limit", given.text("--memory-limit"))};
    if (given.has("--log-level"))
        reading.log_level = parse_word<LogLevel>(
            "--log-level", given.text("--log-level"),
            {{"error", LogLevel::error}, {"warning", LogLevel::warning}, {"info", LogLevel::info}});
    return reading;
}

} // namespace prelight::app
