#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace prelight {

/// A file that appears whole or not at all: it is written under a hidden temporary name in the
/// target's own folder (so that the rename stays on one file system) and renamed by `commit`.
/// Without a commit, for instance because an exception passes, the temporary file is removed.
///
///     AtomicFile file(path);
///     file.write(bytes);      // or hand file.temporary() to a library that opens files itself
///     file.commit();
class AtomicFile {
public:
    /// Creates the empty temporary file. Throws Error "FILE: REASON", FILE being `target`, when the
    /// folder is missing or cannot be written, or when `target` is a folder or has no name.
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// The name to write to until `commit`.
    const std::filesystem::path& temporary() const { return temporary_; }
    /// Appends bytes to the temporary file. Throws Error (disk full …).
    void write(std::span<const std::byte> bytes);
    void write(const void* data, size_t size);
    /// Renames the temporary file to the target, replacing what was there. Throws Error.
    void commit();

private:
    std::filesystem::path target_;
    std::filesystem::path temporary_;
    int descriptor_ = -1;
    bool committed_ = false;
};

} // namespace prelight
