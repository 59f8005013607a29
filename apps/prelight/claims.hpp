#pragma once
#include "scene_source.hpp"

#include <optional>
#include <prelight/device.hpp>
#include <string>
#include <vector>

namespace prelight::app {

enum class Verdict { agrees, does_not, too_close, not_measured };

/// A sentence of a source text beside figures of ours.
struct Claim {
    std::string id;     ///< one word, for programs
    std::string claim;  ///< what the text says
    std::string source; ///< which text
    std::string how;    ///< what `a` and `b` are, and how they came about
    std::string unit = "ms";
    std::optional<double> a, b; ///< the text's larger side first; sizes: ours, then the text's
    double from = 0;            ///< the ratio a / b agrees from here …
    std::optional<double> to;   ///< … to here; absent: or any larger
    bool apart = true;          ///< no sample of `a` is among those of `b`, nor the other way round

    /// Absent when a figure is absent, or `b` or `a` is not above 0: too small to measure.
    std::optional<double> ratio() const;
    Verdict verdict() const;
};

const char* verdict_name(Verdict verdict);

/// What a preset's attachments take.
struct PresetSize {
    std::string preset;
    double bytes = 0;    ///< a pixel, images that share memory counted once
    double unshared = 0; ///< a pixel, every image
};

struct ClaimScene {
    Device& device;
    const World& world;
    const PlacedCamera& camera;
    uint32_t width, height;
    uint32_t frames; ///< timed, of each way to render
    bool software;   ///< whole frames are compared by CPU time, not device time
};

/// Claims about time, measured interleaved. Throws Error.
std::vector<Claim> time_claims(const ClaimScene& scene);
/// Claims about memory: computed from formats, but for the last, which is what our buffers take.
std::vector<Claim> size_claims(const ClaimScene& scene);
std::vector<PresetSize> preset_sizes(const ClaimScene& scene);

} // namespace prelight::app
