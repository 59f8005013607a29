#pragma once
#include "log.hpp"

#include <cstdint>
#include <string>

namespace prelight::app {

/// `--scene`, `--strict`, `--log-level`, `--memory-limit` as text.
struct SceneReadingText {
    std::string scene, log_level, memory_limit;
    bool strict = false;
};

/// How a scene's file is read, and what is told of it.
struct SceneReading {
    std::string scene;   ///< name or index of the file's scene; empty: its default
    bool strict = false; ///< warnings about the file are errors
    LogLevel log_level = LogLevel::info;
    uint64_t memory_limit = 0; ///< LoadOptions::memory_limit
};

/// Adds what every command that reads a scene has; templates, so that only the units that parse include CLI11.
template <class Sub, class Option>
void add_file_options(Sub& sub, const Option& option, SceneReadingText& text) {
    sub.add_flag("--strict", text.strict, "What would be a warning about the file is an error");
    option("--log-level", text.log_level, "LEVEL", "What stderr shows: error, warning or info (default)");
    option("--memory-limit", text.memory_limit, "SIZE",
           "Memory to plan with when a file is read, as in 512M or 4G (default: what is free)");
}
template <class Sub, class Option>
void add_reading_options(Sub& sub, const Option& option, SceneReadingText& text) {
    option("--scene", text.scene, "NAME|INDEX", "Which of the file's scenes (default the file's own default)");
    add_file_options(sub, option, text);
}

/// Throws UsageError.
SceneReading parse_reading(const SceneReadingText& text);

} // namespace prelight::app
