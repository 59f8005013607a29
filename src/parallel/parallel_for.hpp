#pragma once
#include <atomic>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace prelight {

/// Calls `work(i)` for every i below `count`, on all processors, and comes back when all are done. The
/// calls must not depend on each other, so that their results do not depend on the number of
/// processors. Passes on the first exception.
template <typename Work>
void parallel_for(uint32_t count, Work&& work) {
    std::atomic<uint32_t> next{0};
    std::exception_ptr failure;
    std::mutex failure_lock;
    const auto run = [&] {
        try {
            for (uint32_t i = next++; i < count; i = next++)
                work(i);
        } catch (...) {
            const std::lock_guard guard(failure_lock);
            failure = std::current_exception();
            next = count;
        }
    };
    {
        std::vector<std::jthread> threads;
        for (unsigned i = 1; i < std::thread::hardware_concurrency() && i < count; ++i)
            threads.emplace_back(run);
        run();
    }
    if (failure)
        std::rethrow_exception(failure);
}

/// parallel_for() over the rows of a picture, some in each turn: a small picture is not worth a thread.
template <typename Work>
void parallel_rows(uint32_t count, Work&& work) {
    constexpr uint32_t rows = 32;
    parallel_for((count + rows - 1) / rows, [&](uint32_t turn) {
        for (uint32_t y = turn * rows; y < count && y < (turn + 1) * rows; ++y)
            work(y);
    });
}

} // namespace prelight
