#include <cstdint>
#include <cstdlib>
#include <limits>
#include <platform/program/heap.hpp>

#ifdef __GLIBC__
#include <malloc.h>
#include <platform/huge_pages.hpp>
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace prelight {

#ifdef __GLIBC__
namespace {

bool limited(decltype(RLIMIT_AS) resource) {
    rlimit limit = {};
    return getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

/// The first pages of a picture's memory come one by one, each by a page fault, which in a virtual machine may take
/// microseconds: of a small picture of a real scene they were a third of all time. So the heap grows once by more than
/// most pictures need, and where the system asks to be asked (`madvise`, as Debian has it), for huge pages. Only what
/// is used becomes memory.
void grow_in_huge_pages() {
    constexpr size_t huge = size_t(2) << 20, room = size_t(1536) << 20, small = size_t(1) << 20;
    const uintptr_t before = reinterpret_cast<uintptr_t>(sbrk(0));
    mallopt(M_TOP_PAD, static_cast<int>(room));
    void* volatile grown = std::malloc(small); // volatile: the pair would be left out
    std::free(grown);
    mallopt(M_TOP_PAD, static_cast<int>(small));
    mallopt(M_MMAP_MAX, 0); // also what would else be mapped by itself
    const uintptr_t from = (before + huge - 1) / huge * huge, to = reinterpret_cast<uintptr_t>(sbrk(0));
    if (from < to) // an address of the heap's, which no object points to
        ask_for_huge_pages(reinterpret_cast<void*>(from), to - from);
}

} // namespace

void set_up_heap() {
    // A software device takes megabytes from this process's heap in every frame and gives them back at its end. Left to
    // itself the C library hands them on to the system each time, and getting them again costs page faults: a fifth of
    // a frame.
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
    // Each thread's heap of its own reserves 64 MiB: where address space is limited, that is what runs out first.
    if (limited(RLIMIT_AS))
        mallopt(M_ARENA_MAX, 1);
    else if (!limited(RLIMIT_DATA))
        grow_in_huge_pages();
}
#else
void set_up_heap() {}
#endif

} // namespace prelight
