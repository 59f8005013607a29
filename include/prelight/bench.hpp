#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <prelight/device.hpp>
#include <prelight/export.hpp>
#include <prelight/metrics.hpp>
#include <prelight/scene.hpp>
#include <string>
#include <vector>

namespace prelight {

/// Figures of one encoding of normals.
struct EncodingFigures {
    std::string name;         ///< value of the setting `normals`
    std::string target;       ///< format of the normal target on this device
    uint32_t bits = 0;        ///< that hold the normal
    uint32_t bytes = 0;       ///< a pixel, with the roughness target of those that need one
    uint32_t directions = 0;  ///< measured
    double mean = 0;          ///< angle between a direction and what comes back, degrees
    double percentile_99 = 0; ///< 99 % of the directions are off by no more
    double max = 0;           ///< degrees: the direction that is off most
    Comparison picture;       ///< of the light pre-pass with this encoding, against its reference
};

/// Figures of one place where view depth is read from.
struct DepthFigures {
    std::string name;   ///< value of the setting `depth`
    std::string target; ///< its format
    uint32_t bytes = 0; ///< a pixel, beside the depth attachment; 0 for the attachment itself
    /// Largest relative error of a depth between 0.1 m and 10 km that goes through the target; absent for the
    /// attachment, where it depends on the camera.
    std::optional<double> relative;
    Comparison picture; ///< as above
};

/// How bench_encodings() and bench_depth_sources() measure.
struct EncodingBench {
    uint32_t directions = 2'097'152;                  ///< evenly over the sphere; rounded up to whole rows of 1,024
    uint32_t width = 640;                             ///< of the pictures, pixels
    uint32_t height = 360;                            ///< likewise
    std::function<void(const EncodingFigures&)> done; ///< called after each encoding; may be empty
};

/// Sends directions through the real target of every normal encoding on `device`, and renders `world` with
/// each ([ggx], otherwise default settings, textures bilinear on level 0) against the reference of
/// the same form. The result does not depend on how often or when it runs. Throws Error.
PRELIGHT_API std::vector<EncodingFigures> bench_encodings(Device& device, const World& world,
                                                          const PlacedCamera& camera, const EncodingBench& options);
/// The same for each source of depth, with normals=oct32, whose own error is the smallest. Of `options`
/// the picture's size is used.
PRELIGHT_API std::vector<DepthFigures> bench_depth_sources(Device& device, const World& world,
                                                           const PlacedCamera& camera, const EncodingBench& options);

} // namespace prelight
