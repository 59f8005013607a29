#include "progress.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace prelight::app {
namespace {

constexpr size_t bar_width = 24;

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// Columns of the terminal: a longer line would wrap, and wrapped lines cannot be redrawn in place.
size_t columns() {
    winsize size = {};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

} // namespace

Progress::Progress() : shown_(isatty(STDERR_FILENO) == 1), start_(now()) {}

Progress::~Progress() {
    if (shown_)
        fmt::print(stderr, "\r\033[K");
}

void Progress::show(double share, std::string_view what) {
    if (!shown_)
        return;
    const double part = std::clamp(share, 0.0, 1.0);
    const auto filled = static_cast<size_t>(part * double(bar_width));
    const auto seconds = static_cast<unsigned>(now() - start_);
    std::string line = fmt::format("[{:#<{}}{:.<{}}] {:3d} % {}:{:02d}  {}", "", filled, "",
                                   bar_width - filled, static_cast<int>(part * 100), seconds / 60,
                                   seconds % 60, what);
    line.resize(std::min(line.size(), columns() - 1));
    fmt::print(stderr, "\r{}\033[K", line);
    std::fflush(stderr);
}

} // namespace prelight::app
