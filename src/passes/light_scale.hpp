#pragma once
#include "lighting.hpp"

namespace prelight::passes {

/// What a target in fixed point is to the light that it holds.
struct FixedPoint {
    float codes = 255;              ///< steps of its channels
    float most = 32;                ///< light beyond this makes no difference to a picture: no scale is larger
    bool packed = false;            ///< specular light is one channel, as luminance
    uint32_t first = 7, second = 7; ///< channels that hold light, R 1 to A 8, of the first and the second image
};
FixedPoint fixed_point(const LightModel& model);
/// RT0 of a G-buffer.
FixedPoint fixed_point_of_deferred();

/// The scale of light in fixed point: Engel's "scale value", found for each frame from the light that its surfaces
/// get, and a count of the pixels that the target does not hold. Alive as long as the frame graph.
class LightScale {
public:
    /// `measured`: ViewSettings::measures_light.
    LightScale(const resident::View& view, const FixedPoint& form, bool measured);
    /// Before anything is stored by the scale: sums all lights on some of the pixels, and chooses from their histogram.
    /// Deferred shading: `lighting` has buffers that gbuffer_pass() drew small, by light_sample_step().
    void measure(graph::FrameGraph& graph, const resident::View& view, const LightingInputs& lighting) const;
    /// After the light pass; the same image twice where there is one.
    void count_clipped(graph::FrameGraph& graph, const resident::View& view, graph::ImageId first,
                       graph::ImageId second) const;
    /// Of the last frame that was recorded, which must be done; adds the line that says what was lost.
    void tell(Stats& stats) const;

private:
    FixedPoint form_;
    double fixed_scale_;
    bool measured_;
    struct Shared;
    std::shared_ptr<Shared> shared_;
};

} // namespace prelight::passes
