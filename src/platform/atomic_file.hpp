#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace prelight {

/// A file that appears whole or not at all: it is written under a hidden temporary name in the
/// target's own folder (so that the rename stays on one file system) and renamed by `commit`.
/// Without a commit, for instance because an exception passes, the temporary file is removed.
/// Where the target is a symbolic link, what it leads to is written, and the link stays. A device or a
/// pipe is written directly, for there is nothing to rename.
///
///     AtomicFile file(path);
///     file.write(bytes);
///     file.commit();
class AtomicFile {
public:
    /// Creates the empty temporary file. Throws Error "FILE: REASON", FILE being `target`, when the
    /// folder is missing or cannot be written, or when `target` is a folder or has no name.
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Where the bytes lie until `commit`; empty for a device or a pipe.
    const std::filesystem::path& temporary() const { return temporary_; }
    /// Appends bytes to the temporary file. Throws Error (disk full …).
    void write(std::span<const std::byte> bytes);
    void write(const void* data, size_t size);
    /// Renames the temporary file to the target, replacing what was there. Throws Error.
    void commit();

private:
    void open_temporary();
    void open_device();

    std::filesystem::path name_;   ///< as it was given, for messages
    std::filesystem::path target_; ///< what it leads to
    std::filesystem::path temporary_;
    int descriptor_ = -1;
    int slot_ = -1; ///< in the table of temporary files
};

/// The file that `path` leads to through symbolic links, which need not be there yet. Throws Error: links in a circle.
std::filesystem::path follow_links(const std::filesystem::path& path);

/// Removes the temporary files of this process that were not committed. For a handler of fatal signals: it calls
/// nothing but unlink().
void remove_temporary_files() noexcept;

} // namespace prelight
