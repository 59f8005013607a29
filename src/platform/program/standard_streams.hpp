#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace prelight {

/// A standard stream that is closed leads to nothing from here on: else the first file that is opened would take its
/// number, and what is printed would go into that file. Before anything is opened.
void keep_standard_streams();

/// "-": standard input as a scene, standard output as a file that is written.
bool is_standard_stream(const std::filesystem::path& path);

/// A file with all that standard input has, which is read once. Throws Error: it is a terminal, or cannot be read.
std::filesystem::path standard_input_file();

/// Throws std::system_error when it cannot be written.
void write_standard_output(std::span<const std::byte> bytes);

} // namespace prelight
