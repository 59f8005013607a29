#pragma once
#include "log.hpp"

#include <string>

namespace prelight::app {

/// `--scene`, `--strict`, `--log-level` as text.
struct SceneReadingText {
    std::string scene, log_level;
    bool strict = false;
};

/// How a scene's file is read, and what is told of it.
struct SceneReading {
    std::string scene; ///< name or index of the file's scene; empty: its default
    bool strict = false; ///< warnings about the file are errors
    LogLevel log_level = LogLevel::info;
};

/// Adds what every command that reads a scene has; templates, so that only the units that parse include CLI11.
template <class Sub, class Option>
void add_log_options(Sub& sub, const Option& option, SceneReadingText& text) {
    sub.add_flag("--strict", text.strict, "What would be a warning about the file is an error");
    option("--log-level", text.log_level, "LEVEL", "What stderr shows: error, warning or info (default)");
}
template <class Sub, class Option>
void add_reading_options(Sub& sub, const Option& option, SceneReadingText& text) {
    option("--scene", text.scene, "NAME|INDEX", "Which of the file's scenes (default the file's own default)");
    add_log_options(sub, option, text);
}

/// Throws UsageError.
SceneReading parse_reading(const SceneReadingText& text);

} // namespace prelight::app
