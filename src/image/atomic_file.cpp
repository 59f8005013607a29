#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <image/atomic_file.hpp>
#include <prelight/error.hpp>
#include <unistd.h>
#include <utility>

namespace prelight {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason) {
    throw Error(fmt::format("{}: {}", file.string(), reason));
}

} // namespace

AtomicFile::AtomicFile(std::filesystem::path target) : target_(std::move(target)) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    if (target_.filename().empty())
        fail(target_, "not the name of a file");
    if (fs::is_directory(target_, ignored))
        fail(target_, "is a folder");
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    if (!fs::exists(folder, ignored))
        fail(target_, fmt::format("folder {} does not exist", folder.string()));
    if (!fs::is_directory(folder, ignored))
        fail(target_, fmt::format("{} is not a folder", folder.string()));

    // O_EXCL instead of mkstemp: the file's permissions then follow the user's umask.
    for (int attempt = 0; descriptor_ < 0; ++attempt) {
        temporary_ =
            folder / fmt::format(".{}.{}-{}.tmp", target_.filename().string(), getpid(), attempt);
        descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && (errno != EEXIST || attempt == 1000))
            fail(target_, fmt::format("cannot be written ({})", std::strerror(errno)));
    }
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0)
        close(descriptor_);
    if (!committed_) {
        std::error_code ignored;
        std::filesystem::remove(temporary_, ignored);
    }
}

void AtomicFile::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t done = ::write(descriptor_, bytes.data(), bytes.size());
        if (done < 0 && errno == EINTR)
            continue;
        if (done < 0)
            fail(target_, fmt::format("cannot be written ({})", std::strerror(errno)));
        bytes = bytes.subspan(static_cast<size_t>(done));
    }
}

void AtomicFile::write(const void* data, size_t size) {
    write({static_cast<const std::byte*>(data), size});
}

void AtomicFile::commit() {
    // close() is where some file systems report a full disk.
    if (close(std::exchange(descriptor_, -1)) != 0)
        fail(target_, fmt::format("cannot be written ({})", std::strerror(errno)));
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
        fail(target_, fmt::format("cannot be replaced ({})", std::strerror(errno)));
    committed_ = true;
}

} // namespace prelight
