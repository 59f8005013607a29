#pragma once
#include <cstddef>
#include <cstdint>
#include <new>
#include <platform/huge_pages.hpp>
#include <vector>

namespace prelight {

/// For what is written as a whole right after it has been allocated: nothing is set to zero before, and what is large
/// lies in huge pages where the system gives them to who asks, for a page fault each 4 KiB takes longer than reading
/// them from the system's cache.
template <class T>
struct UnsetAllocator {
    using value_type = T;
    UnsetAllocator() = default;
    template <class U>
    UnsetAllocator(const UnsetAllocator<U>&) {}

    T* allocate(size_t count) {
        if (count > SIZE_MAX / sizeof(T))
            throw std::bad_array_new_length();
        const size_t bytes = count * sizeof(T);
        if (bytes < large)
            return static_cast<T*>(::operator new(bytes));
        void* memory = ::operator new(bytes, huge_page);
        ask_for_huge_pages(memory, bytes / static_cast<size_t>(huge_page) * static_cast<size_t>(huge_page));
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, size_t count) {
        if (count * sizeof(T) < large)
            ::operator delete(memory);
        else
            ::operator delete(memory, huge_page);
    }
    template <class U>
    void construct(U* at) noexcept {
        ::new (static_cast<void*>(at)) U;
    }
    template <class U, class... Arguments>
    void construct(U* at, Arguments&&... arguments) {
        ::new (static_cast<void*>(at)) U(static_cast<Arguments&&>(arguments)...);
    }
    template <class U>
    bool operator==(const UnsetAllocator<U>&) const {
        return true;
    }

private:
    static constexpr std::align_val_t huge_page{size_t(2) << 20};
    static constexpr size_t large = size_t(8) << 20; ///< bytes
};

/// What a file holds. Bytes that resize() adds hold anything.
using FileBytes = std::vector<uint8_t, UnsetAllocator<uint8_t>>;

} // namespace prelight
