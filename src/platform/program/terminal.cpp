#include <platform/program/terminal.hpp>
#include <sys/ioctl.h>
#include <unistd.h>

namespace prelight {

bool is_terminal(std::FILE* stream) { return isatty(fileno(stream)) == 1; }

size_t columns_of(std::FILE* stream) {
    winsize size = {};
    return ioctl(fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

} // namespace prelight
