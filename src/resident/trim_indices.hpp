#pragma once
#include "scene.hpp"
#include "screen_triangles.hpp"
#include <glm/mat4x4.hpp>
#include <shared/frame.h>
#include <vector>

namespace prelight::resident {

/// What index trimming has to know of the picture.
struct TrimView {
    glm::mat4 clip_from_world{1}; ///< FrameConstants::clip_from_world
    float width = 0, height = 0;  ///< pixels
    uint32_t subpixel_bits = 8;   ///< VkPhysicalDeviceLimits::subPixelPrecisionBits
    uint32_t samples = 1;         ///< one at the pixel's centre, or several anywhere within
    bool both_faces = false;      ///< of every material: nothing faces away
};

/// Leaves out triangles that cannot show, on the host: those that face away, those off screen, and those
/// that cover no sample; whole objects first. A triangle that the device's own rounding might let show is kept, so a
/// picture is the same byte for byte.
class IndexTrimmer {
public:
    explicit IndexTrimmer(const TrimView& view) { look_from(view); }
    void look_from(const TrimView& view);
    /// Writes the indices of what may show of the draw's primitive to `out`, which has room for all of them; returns
    /// how many. `object`: where it stands.
    size_t trim(const Draw& draw, const shared::ObjectData& object, uint32_t* out);

private:
    /// Where the object's box lies on the screen. Outside: not one sample is in it. Inside: no side of the picture cuts
    /// it, and every vertex has a known place.
    enum class Place { outside, inside, crossing };

    void look_at(const Draw& draw, const shared::ObjectData& object);
    Place place_of(const Draw& draw) const;

    TrimView view_;
    ScreenPlacing placing_;
    TriangleTest test_;
    std::vector<float> x_, y_; ///< ScreenVertices of the primitive
    std::vector<uint32_t> outside_;
};

} // namespace prelight::resident
