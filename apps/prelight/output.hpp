#pragma once
#include <platform/program/interrupt.hpp>

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace prelight::app {

/// Throws Error naming `path` when a file cannot be made there: asked before work that takes long.
void check_writable(const std::filesystem::path& path);

/// Throws UsageError when one of `outputs` is also among `inputs`, or two outputs are one file: by device and inode,
/// through symbolic and hard links, and not by name. Empty names are left out; devices and pipes can be written twice.
void check_distinct(std::span<const std::filesystem::path> outputs, std::span<const std::filesystem::path> inputs);
/// The same for a folder whose files will be replaced: no input may lie in it.
void check_outside(const std::filesystem::path& folder, std::span<const std::filesystem::path> inputs);

/// Writes a text file that appears whole or not at all. Throws Error naming `path`.
void save_text(std::string_view text, const std::filesystem::path& path);

} // namespace prelight::app
