#pragma once
#include "log.hpp"

#include <cstdint>
#include <string>

namespace prelight::app {

class Given;

/// How a scene's file is read, and what is told of it.
struct SceneReading {
    std::string scene;   ///< name or index of the file's scene; empty: its default
    bool strict = false; ///< warnings about the file are errors
    LogLevel log_level = LogLevel::info;
    uint64_t memory_limit = 0; ///< LoadOptions::memory_limit
};

/// `--scene`, `--strict`, `--log-level`, `--memory-limit`, `--quiet`. Throws UsageError.
SceneReading parse_reading(const Given& given);

} // namespace prelight::app
