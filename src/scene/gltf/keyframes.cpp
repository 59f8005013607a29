#include <algorithm>
#include <cmath>
#include <numeric>
#include <scene/gltf/keyframes.hpp>

namespace prelight::gltf {
namespace {

/// One line for all keyframes of a sampler with one fault.
void tell(const Item& item, std::string_view kind, uint64_t count, size_t first, float time, std::string_view repair) {
    if (count > 0)
        item.warnings().add(kind, item.label(),
                            fmt::format("keyframe {} (at {:.6g} s) {}; {}", first, time, kind, repair), count);
}

} // namespace

void repair_keyframes(const Item& item, AnimationSampler& sampler, size_t values) {
    const std::vector<float>& times = sampler.times;
    const auto of = [&](size_t key) { return sampler.values.begin() + std::ptrdiff_t(key * values); };
    const auto is_good = [&](size_t key) {
        return std::isfinite(times[key]) && std::all_of(of(key), of(key + 1), [](float v) { return std::isfinite(v); });
    };
    std::vector<size_t> order;
    uint64_t lost = 0, negative = 0, unsorted = 0, equal = 0;
    size_t first_lost = 0, first_negative = 0, first_unsorted = 0, first_equal = 0;
    for (size_t key = 0; key < times.size(); ++key) {
        if (!is_good(key)) {
            first_lost = lost++ == 0 ? key : first_lost;
            continue;
        }
        if (times[key] < 0)
            first_negative = negative++ == 0 ? key : first_negative;
        if (!order.empty() && times[key] < times[order.back()])
            first_unsorted = unsorted++ == 0 ? key : first_unsorted;
        order.push_back(key);
    }
    if (unsorted > 0)
        std::ranges::stable_sort(order, {}, [&](size_t key) { return times[key]; });

    AnimationSampler out{.interpolation = sampler.interpolation};
    bool second = false; // the last keyframe kept is a second one of its time
    for (const size_t key : order) {
        const bool later = out.times.empty() || times[key] > out.times.back();
        if (!later)
            first_equal = equal++ == 0 ? key : first_equal;
        if (!later && second) {
            out.values.resize(out.values.size() - values);
        } else {
            const float time =
                later ? times[key] : std::nextafter(out.times.back(), std::numeric_limits<float>::infinity());
            if (!std::isfinite(time))
                continue;
            out.times.push_back(time);
            second = !later;
        }
        out.values.insert(out.values.end(), of(key), of(key + 1));
    }
    tell(item, "is not finite", lost, first_lost, lost ? times[first_lost] : 0, "it is left out");
    tell(item, "is before 0 s", negative, first_negative, negative ? times[first_negative] : 0, "it counts");
    tell(item, "is before the one that it follows", unsorted, first_unsorted, unsorted ? times[first_unsorted] : 0,
         "they are sorted by time");
    tell(item, "is at the time of another", equal, first_equal, equal ? times[first_equal] : 0,
         "the animation jumps there from the first of them to the last");
    if (lost + unsorted + equal > 0)
        sampler = std::move(out);
}

} // namespace prelight::gltf
