#include <platform/huge_pages.hpp>
#include <sys/mman.h>

namespace prelight {

void ask_for_huge_pages(void* memory, size_t bytes) noexcept {
#ifdef MADV_HUGEPAGE
    madvise(memory, bytes, MADV_HUGEPAGE);
#else
    static_cast<void>(memory), static_cast<void>(bytes);
#endif
}

} // namespace prelight
