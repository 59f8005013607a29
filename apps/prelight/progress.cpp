#include "progress.hpp"

#include "log.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <platform/program/terminal.hpp>
#include <string>

namespace prelight::app {
namespace {

constexpr size_t bar_width = 24;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Seconds without a line after which a step says that it is still at work.
constexpr double longest_silence = 30;

} // namespace

std::string clock_text(double seconds) {
    const auto whole = static_cast<unsigned long>(seconds);
    return whole < 3600 ? fmt::format("{}:{:02d}", whole / 60, whole % 60)
                        : fmt::format("{}:{:02d}:{:02d}", whole / 3600, whole / 60 % 60, whole % 60);
}

Progress::Progress() : terminal_(is_terminal(stderr)), start_(now()) {}

Progress::~Progress() { clear(); }

void Progress::clear() const {
    if (terminal_ && !is_quiet())
        std::fputs("\r\033[K", stderr);
}

void Progress::step(double share, std::string_view what) {
    if (is_quiet())
        return;
    if (first_ < 0)
        first_ = share;
    terminal_ ? draw_bar(share, what) : print_line(share, what);
}

void Progress::show(double share, std::string_view what) {
    if (is_quiet())
        return;
    if (terminal_)
        draw_bar(share, what);
    else if (now() - said_ > longest_silence)
        print_line(share, what);
}

std::string Progress::left_text(double share) const {
    const double gone = now() - start_, done = std::clamp(share, 0.0, 1.0) - std::max(first_, 0.0);
    if (gone <= 1 || done <= 0.02)
        return {};
    return fmt::format(", about {} left", clock_text(gone / done * (1 - std::clamp(share, 0.0, 1.0))));
}

void Progress::draw_bar(double share, std::string_view what) const {
    const double part = std::clamp(share, 0.0, 1.0);
    const auto filled = static_cast<size_t>(part * double(bar_width));
    std::string line = fmt::format("[{:#<{}}{:.<{}}] {:3d} % {}{}  {}", "", filled, "", bar_width - filled,
                                   static_cast<int>(part * 100), clock_text(now() - start_), left_text(share), what);
    // A longer line would wrap, and wrapped lines cannot be redrawn in place.
    line.resize(std::min(line.size(), columns_of(stderr) - 1));
    std::fputs(fmt::format("\r{}\033[K", line).c_str(), stderr);
    std::fflush(stderr);
}

void Progress::print_line(double share, std::string_view what) {
    said_ = now();
    std::fputs(fmt::format("[{:3d} %] {}{}: {}\n", static_cast<int>(share * 100), clock_text(said_ - start_),
                           left_text(share), what)
                   .c_str(),
               stderr);
    std::fflush(stderr);
}

} // namespace prelight::app
