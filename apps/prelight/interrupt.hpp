#pragma once

namespace prelight::app {

/// Ctrl-C and the like end the program at once, but not while a file is being written: then right
/// after. Call once, before the first WriteGuard.
void handle_interrupts();

/// While one lives, an interrupt waits. When the last one goes, a waiting interrupt ends the
/// program.
class WriteGuard {
public:
    WriteGuard();
    ~WriteGuard();
    WriteGuard(const WriteGuard&) = delete;
    WriteGuard& operator=(const WriteGuard&) = delete;
};

} // namespace prelight::app
