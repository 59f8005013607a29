#pragma once
#include <string>
#include <string_view>

namespace prelight::app {

/// "0:12", "1:03:20".
std::string clock_text(double seconds);

/// How far a long command is, on stderr: on a terminal a bar, redrawn in place; elsewhere a line a step, with the time
/// that is left as far as it can be told.
class Progress {
public:
    Progress();
    /// Clears the bar's line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Clears the bar's line, for other text to be printed.
    void clear() const;

    /// `share` of the work, 0 … 1, is done, and a step begins: `what`.
    void step(double share, std::string_view what);
    /// Within a step. Off a terminal it is told when nothing has been for a while.
    void show(double share, std::string_view what);

private:
    /// "about 0:42", once it can be told; else empty.
    std::string left_text(double share) const;
    void draw_bar(double share, std::string_view what) const;
    void print_line(double share, std::string_view what);

    bool terminal_ = false;
    double start_ = 0;  ///< seconds
    double said_ = 0;   ///< when the last line was printed
    double first_ = -1; ///< share of the work that was there at the first step
};

} // namespace prelight::app
