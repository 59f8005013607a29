#pragma once
#include <cstdint>

namespace prelight {

/// Bytes that this process may still take as the machine is now: the least of what the kernel calls available, what the
/// control group leaves, and what RLIMIT_AS and RLIMIT_DATA leave. 1 GiB where none of them can be found out.
uint64_t spare_memory();

} // namespace prelight
