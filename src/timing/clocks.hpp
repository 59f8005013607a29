#pragma once

namespace prelight {

/// User and system time of this process so far, milliseconds.
double process_ms();
/// A steady clock's reading, milliseconds.
double wall_ms();

} // namespace prelight
