#pragma once
#include <cstdint>
#include <filesystem>
#include <platform/file_bytes.hpp>
#include <stdexcept>
#include <string>

namespace prelight {

/// Why a file could not be read, as one short reason without the file's name.
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Most bytes that a file of each kind may have.
namespace largest_file {
inline constexpr uint64_t scene = uint64_t(4) << 30;       ///< and each buffer: what a .glb's own header can say
inline constexpr uint64_t picture = 0x7fffffff;            ///< the codecs count in int
inline constexpr uint64_t environment = uint64_t(2) << 30; ///< 16,384 × 8,192 pixels of three floats and some more
inline constexpr uint64_t light_profile = uint64_t(16) << 20;
inline constexpr uint64_t material = uint64_t(1) << 20;
inline constexpr uint64_t figures = uint64_t(256) << 20;  ///< JSON of the program's own
inline constexpr uint64_t recording = uint64_t(64) << 20; ///< of input
inline constexpr uint64_t pipeline_cache = uint64_t(256) << 20;
} // namespace largest_file

// The one way in which the program reads a file of a user's or a stranger's. Only a regular file is read (also at the
// end of symbolic links): a pipe would block, a device may never end. More than `largest` bytes are refused, whatever
// size the file claims and however it grows meanwhile, so that time and memory are bounded.

/// The whole file with `padding` zero bytes after it. Throws FileError.
FileBytes read_bytes(const std::filesystem::path& file, uint64_t largest, size_t padding = 0);
/// The whole file. Throws Error "FILE: REASON".
FileBytes read_file(const std::filesystem::path& file, uint64_t largest);
std::string read_text_file(const std::filesystem::path& file, uint64_t largest);

} // namespace prelight
