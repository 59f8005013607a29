#pragma once
#include <string_view>

namespace prelight::app {

/// A bar on stderr, redrawn in place; silent where stderr is no terminal (a log keeps no bars).
class Progress {
public:
    Progress();
    /// Clears the bar's line.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `share` of the work, 0 … 1, is done, and `what` begins.
    void show(double share, std::string_view what);

private:
    bool shown_ = false;
    double start_ = 0; ///< seconds
};

} // namespace prelight::app
