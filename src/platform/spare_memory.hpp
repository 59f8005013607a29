#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace prelight {

/// What this process may still take, and who says so.
struct MemoryRoom {
    uint64_t bytes = 0;
    std::string limit; ///< "ulimit -v", …
    /// Reserved but untouched memory counts too: a limit of the address space.
    bool reserved = false;
};

/// RLIMIT_AS, RLIMIT_DATA, the limits of the control groups, and what the machine has left with its swap.
std::vector<MemoryRoom> memory_rooms();

/// Bytes of the narrowest of them; 1 GiB where none can be found out.
uint64_t spare_memory();

} // namespace prelight
