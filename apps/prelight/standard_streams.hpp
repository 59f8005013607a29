#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace prelight::app {

/// "-": standard input as a scene, standard output as a file that is written.
bool is_standard_stream(const std::filesystem::path& path);

/// A file with all that standard input has, which is read once. Throws Error: it is a terminal, or cannot be read.
std::filesystem::path standard_input_file();

/// Throws std::system_error when it cannot be written.
void write_standard_output(std::span<const std::byte> bytes);

} // namespace prelight::app
