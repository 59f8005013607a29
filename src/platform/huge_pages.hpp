#pragma once
#include <cstddef>

namespace prelight {

/// Asks for huge pages for `bytes` bytes from `memory` on, an address of whole pages, where the system gives them to
/// who asks. Changes nothing else.
void ask_for_huge_pages(void* memory, size_t bytes) noexcept;

} // namespace prelight
