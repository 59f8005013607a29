#include "stats_state.hpp"

#include <nlohmann/json.hpp>

namespace nlohmann {

template <class T>
struct adl_serializer<std::optional<T>> {
    static void to_json(json& out, const std::optional<T>& value) { out = value ? json(*value) : json(nullptr); }
    static void from_json(const json& in, std::optional<T>& value) {
        value = in.is_null() ? std::nullopt : std::optional(in.get<T>());
    }
};

} // namespace nlohmann

namespace prelight {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Spread, min, median, max)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PassStats, name, gpu_ms, bytes_read, bytes_written, cpu_ms)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CreatedObjects, allocations, pipelines, buffers, images, descriptor_pools)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HostTimes, lights, culling, objects, record)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ShadowStats, budget, texels, lights, lights_reduced, lights_without, smallest,
                                   largest, tiles_drawn, tiles_reused, casters_drawn)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LightBufferStats, diffuse_scale, specular_scale, clipped_pixels)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(InferredStats, layers, layers_without_slot, unmatched_pixels)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LayerStats, most, mean, exact, approximate)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SettingChoice, key, asked, taken, why)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Stats, device, driver, settings, choices, shading, notes, lights, triangles, draws,
                                   triangles_drawn, draws_skipped, triangles_skipped, frames, wall_ms, cpu_ms, gpu_ms,
                                   passes, attachment_bytes, device_bytes, device_bytes_peak, created, updated_bytes,
                                   frame_bytes, host_ms, shadows, light_buffer, inferred, layers,
                                   attachment_bytes_unshared, pairs_evaluated, pairs_contributing, pairs_counted)

} // namespace prelight

namespace prelight::app {

nlohmann::json stats_state(const Stats& stats) { return stats; }

Stats stats_from_state(const nlohmann::json& state) {
    // A field more in one of these structs does not compile here: it belongs in the lists above.
    [[maybe_unused]] const auto whole = [](const Stats& s, const ShadowStats& w, const LightBufferStats& l,
                                           const InferredStats& i, const LayerStats& o) {
        const auto& [a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14, a15, a16, a17, a18, a19, a20, a21,
                     a22, a23, a24, a25, a26, a27, a28, a29, a30, a31, a32] = s;
        const auto& [b1, b2, b3, b4, b5, b6, b7, b8, b9, b10] = w;
        const auto& [c1, c2, c3] = l;
        const auto& [d1, d2, d3] = i;
        const auto& [e1, e2, e3, e4] = o;
        static_cast<void>(a1);
        static_cast<void>(b1);
        static_cast<void>(c1);
        static_cast<void>(d1);
        static_cast<void>(e1);
    };
    return state.get<Stats>();
}

} // namespace prelight::app
