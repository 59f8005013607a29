#pragma once
#include <string_view>

namespace prelight::app {

/// What stderr shows beside the one line of a failure: `--log-level`.
enum class LogLevel { error, warning, info };

/// `--quiet`, for the whole process: tell() and progress print nothing.
void set_quiet(bool quiet);
bool is_quiet();
/// A line on standard output that says what was done, escaped and flushed. Throws std::system_error when it cannot be
/// printed.
void tell(std::string_view line);

/// Lines on stderr, escaped; those below the level are left out.
class Log {
public:
    explicit Log(LogLevel level) : level_(level) {}
    bool shows(LogLevel level) const { return level <= level_; }
    void warning(std::string_view text) const; ///< "warning: TEXT": about the file
    void note(std::string_view text) const;    ///< "note: TEXT": about the run

private:
    void print(LogLevel level, std::string_view prefix, std::string_view text) const;
    LogLevel level_;
};

} // namespace prelight::app
