#include "commands.hpp"
#include "interrupt.hpp"

#include <cstdio>
#include <fmt/format.h>
#include <new>
#include <prelight/error.hpp>

namespace {

/// One line on stderr, whatever the reason holds, and the exit status.
int fail(std::string reason, int status) {
    while (!reason.empty() && reason.back() == '\n')
        reason.pop_back();
    for (char& c : reason)
        if (c == '\n' || c == '\r')
            c = ' ';
    fmt::print(stderr, "prelight: {}\n", reason);
    return status;
}

} // namespace

int main(int argc, char** argv) {
    using namespace prelight;
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
