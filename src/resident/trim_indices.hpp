#pragma once
#include <glm/mat4x4.hpp>
#include <prelight/scene.hpp>
#include <shared/frame.h>
#include <span>
#include <vector>

namespace prelight::resident {

/// What index trimming has to know of the picture.
struct TrimView {
    glm::mat4 clip_from_world{1}; ///< FrameConstants::clip_from_world
    float width = 0, height = 0;  ///< pixels
    uint32_t subpixel_bits = 8;   ///< VkPhysicalDeviceLimits::subPixelPrecisionBits
    uint32_t samples = 1;         ///< one at the pixel's centre, or several anywhere within
};

/// Leaves out triangles that cannot show, on the host: those that face away, those off screen, and those
/// that cover no sample. A triangle that the device's own rounding might let show is kept, so a
/// picture is the same byte for byte.
class IndexTrimmer {
public:
    explicit IndexTrimmer(const TrimView& view);
    /// Writes the indices of what may show to `out`, which has room for all of them; returns how many.
    /// `object`: where the primitive stands.
    size_t trim(const Primitive& primitive, const shared::ObjectData& object, bool mirrored, bool double_sided,
                uint32_t* out);

private:
    void project(const Primitive& primitive, const shared::ObjectData& object);
    template <bool double_sided>
    size_t select(const std::vector<uint32_t>& indices, float facing, uint32_t* out) const;

    TrimView view_;
    float margin_; ///< pixels that a vertex may be off where the device sees it, or a sample off the pixel's centre
    std::vector<glm::vec2> place_; ///< of each vertex, pixels
    std::vector<uint8_t> outside_; ///< OUTSIDE_… bits
};

} // namespace prelight::resident
