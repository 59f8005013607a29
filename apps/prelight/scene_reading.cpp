#include "scene_reading.hpp"

#include "argument.hpp"

namespace prelight::app {

SceneReading parse_reading(const SceneReadingText& text) {
    SceneReading reading{
        .scene = text.scene, .strict = text.strict, .memory_limit = parse_memory("--memory-limit", text.memory_limit)};
    if (!text.log_level.empty())
        reading.log_level = parse_word<LogLevel>(
            "--log-level", text.log_level,
            {{"error", LogLevel::error}, {"warning", LogLevel::warning}, {"info", LogLevel::info}});
    return reading;
}

} // namespace prelight::app
