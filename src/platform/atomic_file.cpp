#include <atomic>
#include <cerrno>
#include <climits>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <platform/atomic_file.hpp>
#include <prelight/error.hpp>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace prelight {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& file, const std::string& reason) {
    throw Error(fmt::format("{}: {}", file.string(), reason));
}

std::string cannot_be_written(int error) { return fmt::format("cannot be written ({})", std::strerror(error)); }

/// Names of temporary files, where a signal handler finds them: in static storage, and without a lock. More files
/// at once than there are places are not cleaned up after a crash.
struct Slot {
    enum State { free, filling, listed };
    std::atomic<int> state = free;
    char path[PATH_MAX] = {};
};
Slot slots[16];
static_assert(std::atomic<int>::is_always_lock_free);

int list_temporary(const fs::path& file) {
    const std::string path = fs::absolute(file).string();
    for (int i = 0; i < static_cast<int>(std::size(slots)) && path.size() < PATH_MAX; ++i) {
        int expected = Slot::free;
        if (!slots[i].state.compare_exchange_strong(expected, Slot::filling))
            continue;
        std::memcpy(slots[i].path, path.c_str(), path.size() + 1);
        slots[i].state = Slot::listed;
        return i;
    }
    return -1;
}

bool written_directly(const fs::path& file) {
    struct stat status = {};
    return stat(file.c_str(), &status) == 0 && (S_ISCHR(status.st_mode) || S_ISFIFO(status.st_mode));
}

void check_target(const fs::path& target) {
    if (target.filename().empty())
        fail(target, "not the name of a file");
    struct stat status = {};
    if (stat(target.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode))
            fail(target, "is a folder");
        if (!S_ISREG(status.st_mode) && !S_ISCHR(status.st_mode) && !S_ISFIFO(status.st_mode))
            fail(target, "is neither a file nor a pipe");
    } else if (errno == ENAMETOOLONG)
        fail(target, cannot_be_written(errno));
}

void check_folder(const fs::path& name, const fs::path& folder) {
    std::error_code ignored;
    if (!fs::exists(folder, ignored))
        fail(name, fmt::format("folder {} does not exist", folder.string()));
    if (!fs::is_directory(folder, ignored))
        fail(name, fmt::format("{} is not a folder", folder.string()));
}

} // namespace

fs::path follow_links(const fs::path& path) {
    fs::path at = path;
    for (int links = 0; links < 40; ++links) { // as many as the system follows
        std::error_code error;
        if (!fs::is_symlink(at, error))
            return at;
        const fs::path to = fs::read_symlink(at, error);
        if (error)
            fail(path, fmt::format("cannot be written ({})", error.message()));
        at = to.is_absolute() ? to : at.parent_path() / to;
    }
    fail(path, cannot_be_written(ELOOP));
}

AtomicFile::AtomicFile(fs::path target) : name_(std::move(target)) {
    check_target(name_);
    if (written_directly(name_)) {
        if (access(name_.c_str(), W_OK) != 0)
            fail(name_, cannot_be_written(errno));
        return; // opened with the first bytes: a pipe's reader would take an open and a close for the end
    }
    target_ = follow_links(name_);
    open_temporary();
}

void AtomicFile::open_temporary() {
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    check_folder(name_, folder);
    // O_EXCL instead of mkstemp: the file's permissions then follow the user's umask. The target's name has no part in
    // it: it may be as long as names can be.
    for (int attempt = 0; descriptor_ < 0; ++attempt) {
        temporary_ = folder / fmt::format(".prelight-{}-{}.tmp", getpid(), attempt);
        descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && (errno != EEXIST || attempt == 1000))
            fail(name_, cannot_be_written(errno));
    }
    slot_ = list_temporary(temporary_);
}

void AtomicFile::open_device() {
    // Without O_NONBLOCK a pipe that nobody reads would be waited for.
    descriptor_ = open(name_.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor_ < 0)
        fail(name_, errno == ENXIO ? "nobody reads this pipe" : cannot_be_written(errno));
    fcntl(descriptor_, F_SETFL, fcntl(descriptor_, F_GETFL) & ~O_NONBLOCK);
}

AtomicFile::~AtomicFile() {
    if (descriptor_ >= 0)
        close(descriptor_);
    if (!temporary_.empty())
        unlink(temporary_.c_str());
    if (slot_ >= 0)
        slots[slot_].state = Slot::free;
}

void AtomicFile::write(std::span<const std::byte> bytes) {
    if (descriptor_ < 0 && temporary_.empty())
        open_device();
    while (!bytes.empty()) {
        const ssize_t done = ::write(descriptor_, bytes.data(), bytes.size());
        if (done < 0 && errno == EINTR)
            continue;
        if (done < 0)
            fail(name_, cannot_be_written(errno));
        bytes = bytes.subspan(static_cast<size_t>(done));
    }
}

void AtomicFile::write(const void* data, size_t size) { write({static_cast<const std::byte*>(data), size}); }

void AtomicFile::commit() {
    // close() is where some file systems report a full disk.
    if (descriptor_ >= 0 && close(std::exchange(descriptor_, -1)) != 0)
        fail(name_, cannot_be_written(errno));
    if (temporary_.empty())
        return;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0)
        fail(name_, fmt::format("cannot be replaced ({})", std::strerror(errno)));
    temporary_.clear();
}

void remove_temporary_files() noexcept {
    for (const Slot& slot : slots)
        if (slot.state == Slot::listed)
            unlink(slot.path);
}

} // namespace prelight
