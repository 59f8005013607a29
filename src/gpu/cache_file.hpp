#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace prelight::gpu {

/// Where files lie that save a later run work: `prelight` in the user's cache folder. Empty when there is
/// none: nothing is kept then.
std::filesystem::path cache_folder();

/// 128 bits of text that stands for what was added: two FNV-1a hashes that begin differently.
class CacheKey {
public:
    void add(std::string_view bytes);
    std::string text() const; ///< 32 hexadecimal digits

private:
    uint64_t a_ = 0xcbf29ce484222325u, b_ = 0x84222325cbf29ce4u;
};

/// A cache file's own frame around its bytes: magic, length, FNV-1a checksum.
std::vector<std::byte> seal_cache(std::span<const std::byte> payload);
/// The payload, or nothing when the frame is damaged.
std::span<const std::byte> open_cache(std::span<const std::byte> file);

/// The payload of a file that write_cache() made; empty for one that is missing or damaged.
std::vector<std::byte> read_cache(const std::filesystem::path& file);
/// Writes it (temporary name, then rename: processes that write at once don't disturb each other), and makes its
/// folder. Failure is silent: a cache is only a help.
void write_cache(const std::filesystem::path& file, std::span<const std::byte> payload);

/// Removes the files or folders in `folder` that were written longest ago, until `most` are left.
void trim_cache(const std::filesystem::path& folder, size_t most);

} // namespace prelight::gpu
