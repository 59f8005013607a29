#include "commands.hpp"
#include "log.hpp"
#include "terminal.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <new>
#include <platform/program/crash.hpp>
#include <platform/program/heap.hpp>
#include <platform/program/interrupt.hpp>
#include <platform/program/standard_streams.hpp>
#include <prelight/error.hpp>
#include <system_error>

namespace {

/// One line on stderr, whatever the reason holds, and the exit status.
int fail(std::string_view reason, int status) {
    using namespace prelight::app;
    std::fputs(fmt::format("{} {}\n", styled(stderr, Style::failure, "prelight:"), prelight::escaped(reason)).c_str(),
               stderr); // fmt::print would throw if it can't
    return status;
}

/// A write to standard output that failed, whatever has noticed it.
int fail_to_print(int error) {
    return fail(fmt::format("standard output: cannot be written ({})", std::strerror(error)), 1);
}

} // namespace

int main(int argc, char** argv) {
    using namespace prelight;
    set_up_heap();
    keep_standard_streams();
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ); // each result is seen when it is there
    try {
        handle_crashes();
        handle_interrupts();
        const app::Command command = app::parse_command_line(argc, argv);
        app::set_quiet(app::wants_quiet(command));
        std::visit([](const auto& one) { app::run(one); }, command);
        return std::fflush(stdout) == 0 ? 0 : fail_to_print(errno);
    } catch (const UsageError& error) {
        return fail(error.what(), 2);
    } catch (const std::bad_alloc&) {
        return fail("out of memory", 1);
    } catch (const std::system_error& error) {
        return std::ferror(stdout) ? fail_to_print(error.code().value()) : fail(error.what(), 1);
    } catch (const std::exception& error) {
        return fail(error.what(), 1);
    }
}
