#pragma once

namespace prelight {

/// User and system time of this process so far, milliseconds.
double process_ms();
/// User and system time of the calling thread so far, milliseconds.
double thread_ms();
/// A steady clock's reading, milliseconds.
double wall_ms();

} // namespace prelight
