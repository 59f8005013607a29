#include "commands.hpp"
#include "interrupt.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <new>
#include <prelight/error.hpp>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

/// A software device takes megabytes from this process's heap in every frame and gives them back at its
/// end. Left to itself the C library hands them on to the system each time, and getting them again costs
/// page faults: a fifth of a frame.
void keep_heap() {
#ifdef __GLIBC__
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
#endif
}

/// One line on stderr, whatever the reason holds, and the exit status.
int fail(std::string_view reason, int status) {
    fmt::print(stderr, "prelight: {}\n", prelight::escaped(reason));
    return status;
}

} // namespace

int main(int argc, char** argv) {
    using namespace prelight;
    keep_heap();
    try {
        app::handle_interrupts();
        std::visit([](const auto& command) { app::run(command); },
                   app::parse_command_line(argc, argv));
        if (std::fflush(stdout) != 0)
            throw Error("standard output: cannot be written");
        return 0;
    } catch (const UsageError& error) {
        return fail(error.what(), 2);
    } catch (const std::bad_alloc&) {
        return fail("out of memory", 1);
    } catch (const std::exception& error) {
        return fail(error.what(), 1);
    }
}
