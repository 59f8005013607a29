#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <platform/program/standard_streams.hpp>
#include <prelight/error.hpp>
#include <sys/mman.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace prelight {
namespace {

[[noreturn]] void refuse_input(const char* reason) { throw Error(fmt::format("standard input: {}", reason)); }

/// A file in memory, which the reader can map and ask for its size; it goes with the process.
int copy_of_input() {
    if (isatty(STDIN_FILENO) == 1)
        refuse_input("is a terminal: a .glb file is read from there, as in `prelight render - -o a.png < a.glb`");
    const int copy = memfd_create("prelight", MFD_CLOEXEC);
    std::vector<char> buffer(1 << 20);
    for (;;) {
        const ssize_t got = copy < 0 ? -1 : read(STDIN_FILENO, buffer.data(), buffer.size());
        if (got < 0 && errno == EINTR && copy >= 0)
            continue;
        if (got < 0)
            refuse_input(std::strerror(errno));
        if (got == 0)
            return copy;
        for (ssize_t at = 0; at < got;) {
            const ssize_t put = write(copy, buffer.data() + at, static_cast<size_t>(got - at));
            if (put < 0)
                refuse_input(std::strerror(errno));
            at += put;
        }
    }
}

} // namespace

void keep_standard_streams() {
    for (int stream = 0; stream <= 2; ++stream)
        if (fcntl(stream, F_GETFD) < 0)
            open("/dev/null", O_RDONLY); // the lowest free number, which is this one; a write to it fails
}

bool is_standard_stream(const std::filesystem::path& path) { return path == "-"; }

std::filesystem::path standard_input_file() {
    static const int copy = copy_of_input();
    return fmt::format("/proc/self/fd/{}", copy);
}

void write_standard_output(std::span<const std::byte> bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() || std::fflush(stdout) != 0)
        throw std::system_error(errno, std::generic_category(), "standard output");
}

} // namespace prelight
