#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fmt/format.h>
#include <platform/read_file.hpp>
#include <prelight/error.hpp>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace prelight {
namespace {

[[noreturn]] void fail_with_errno(const char* what) {
    throw FileError(fmt::format("{} ({})", what, std::generic_category().message(errno)));
}

const char* kind_of(mode_t mode) {
    return S_ISDIR(mode)                    ? "a folder"
           : S_ISFIFO(mode)                 ? "a pipe"
           : S_ISSOCK(mode)                 ? "a socket"
           : S_ISCHR(mode) || S_ISBLK(mode) ? "a device"
                                            : "something else";
}

void check_regular(const struct stat& status) {
    if (!S_ISREG(status.st_mode))
        throw FileError(fmt::format("is {}, not a file", kind_of(status.st_mode)));
}

class Descriptor {
public:
    /// Never waits: for the other end of a pipe, say, that took a file's place after the first look.
    explicit Descriptor(const std::filesystem::path& file)
        : descriptor_(open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY)) {
        if (descriptor_ < 0)
            fail_with_errno("cannot be opened");
    }
    ~Descriptor() { close(descriptor_); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    struct stat status() const {
        struct stat status {};
        if (fstat(descriptor_, &status) != 0)
            fail_with_errno("cannot be read");
        return status;
    }
    /// 0 at the file's end.
    size_t read(uint8_t* to, size_t size) const {
        for (;;) {
            const ssize_t taken = ::read(descriptor_, to, std::min(size, size_t(1) << 30));
            if (taken >= 0)
                return static_cast<size_t>(taken);
            if (errno != EINTR)
                fail_with_errno("cannot be read");
        }
    }

private:
    int descriptor_;
};

void check_size(uint64_t size, uint64_t largest) {
    if (size > largest)
        throw FileError(fmt::format("is too large: at most {} bytes of such a file are read", largest));
}

template <class Read>
auto naming(const std::filesystem::path& file, const Read& read) {
    try {
        return read();
    } catch (const FileError& error) {
        throw Error(fmt::format("{}: {}", file.string(), error.what()));
    }
}

} // namespace

FileBytes read_bytes(const std::filesystem::path& file, uint64_t largest, size_t padding) {
    struct stat named {};
    if (stat(file.c_str(), &named) != 0)
        fail_with_errno("cannot be opened");
    check_regular(named); // opening a device may already do something
    const Descriptor descriptor(file);
    const struct stat status = descriptor.status();
    check_regular(status);
    const auto claimed = static_cast<uint64_t>(std::max<off_t>(status.st_size, 0));
    check_size(claimed, largest);

    // One byte more than it claims, so that its end is seen. Files of /proc claim 0.
    FileBytes bytes(claimed + std::max<size_t>(padding, 1));
    size_t size = 0;
    while (const size_t taken = descriptor.read(bytes.data() + size, bytes.size() - size)) {
        size += taken;
        check_size(size, largest);
        if (size == bytes.size())
            bytes.resize(size + std::max<size_t>(size / 2, 4096));
    }
    bytes.resize(size + padding);
    std::fill(bytes.end() - static_cast<std::ptrdiff_t>(padding), bytes.end(), uint8_t(0));
    return bytes;
}

FileBytes read_file(const std::filesystem::path& file, uint64_t largest) {
    return naming(file, [&] { return read_bytes(file, largest); });
}

std::string read_text_file(const std::filesystem::path& file, uint64_t largest) {
    const FileBytes bytes = read_file(file, largest);
    return {bytes.begin(), bytes.end()};
}

} // namespace prelight
