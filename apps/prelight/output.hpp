#pragma once
#include "interrupt.hpp"

#include <filesystem>
#include <string_view>

namespace prelight::app {

/// Throws Error naming `path` when a file cannot be made there: asked before work that takes long.
void check_writable(const std::filesystem::path& path);

/// Writes a text file that appears whole or not at all. Throws Error naming `path`.
void save_text(std::string_view text, const std::filesystem::path& path);

} // namespace prelight::app
