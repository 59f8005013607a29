#include <algorithm>
#include <fmt/format.h>
#include <scene/gltf/budget.hpp>

namespace prelight::gltf {

uint64_t Budget::limit(Pool pool) const {
    return pool == Pool::images ? share_ : std::min(share_, geometry_constant + multiple * input_);
}

uint64_t Budget::left(Pool pool) const {
    const uint64_t taken = pool == Pool::images ? images_ : geometry_;
    return limit(pool) - taken; // charge() keeps taken ≤ limit, and the limit only grows
}

void Budget::charge(Pool pool, uint64_t count, uint64_t size) {
    if (size != 0 && count > left(pool) / size)
        throw Exceeded(fmt::format("needs more memory than {} ({} elements of {} bytes, {} MiB left of {} MiB)",
                                   limit(pool) < share_ ? "a file of this size may take" : "the memory limit allows",
                                   count, size, left(pool) >> 20, limit(pool) >> 20));
    used(pool) += count * size;
}

void Budget::charge_work(uint64_t pixels) {
    if (pixels > work_left())
        throw Exceeded(
            fmt::format("the file's pictures have more pixels in all than a file of this size may have ({} million)",
                        (work_ + work_left()) / 1'000'000));
    work_ += pixels;
}

} // namespace prelight::gltf
