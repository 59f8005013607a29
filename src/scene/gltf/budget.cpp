#include <fmt/format.h>
#include <scene/gltf/budget.hpp>

namespace prelight::gltf {

uint64_t Budget::limit(Pool pool) const {
    return (pool == Pool::images ? image_constant : geometry_constant) + multiple * input_;
}

uint64_t Budget::left(Pool pool) const {
    const uint64_t taken = pool == Pool::images ? images_ : geometry_;
    return limit(pool) - taken; // charge() keeps taken ≤ limit, and the limit only grows
}

void Budget::charge(Pool pool, uint64_t count, uint64_t size) {
    if (size != 0 && count > left(pool) / size)
        throw Exceeded(fmt::format("needs more memory than a file of this size may take "
                                   "({} elements of {} bytes, {} MiB left of {} MiB)",
                                   count, size, left(pool) >> 20, limit(pool) >> 20));
    used(pool) += count * size;
}

} // namespace prelight::gltf
