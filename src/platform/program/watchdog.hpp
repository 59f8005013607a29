#pragma once

namespace prelight {

/// Ends the program with one line and status 1 when for so many seconds it has used no processor, read or written
/// nothing and waited for no disk: a driver that missed an allocation may wait for itself for ever. Seconds while the
/// program is stopped don't count, nor under a debugger, while a file is written, or while a WatchdogPause lives.
/// The environment variable PRELIGHT_STANDSTILL gives other seconds; 0: never. A second call changes nothing.
void start_watchdog(unsigned seconds = 60);

/// A wait that is meant to last.
class WatchdogPause {
public:
    WatchdogPause();
    ~WatchdogPause();
    WatchdogPause(const WatchdogPause&) = delete;
    WatchdogPause& operator=(const WatchdogPause&) = delete;
};

} // namespace prelight
