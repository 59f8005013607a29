#pragma once
#include <glm/vec2.hpp>
#include <limits>
#include <prelight/scene.hpp>
#include <shared/frame.h>

namespace prelight::resident {

/// Numbers between two ends; empty until something is added.
struct Interval {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    bool empty() const { return low > high; }
    void add(double value);
    void cut(const Interval& other);
};

/// What the part of a light's volume between near and far plane covers: clip space −1 … 1 over the
/// picture (y downwards), not cut by the picture's edges, and view depth in metres.
struct ScreenBounds {
    Interval x, y, depth;
    /// Nothing of it lies in the picture.
    bool empty() const;
};

/// Bounds of a point light's sphere or a spot's cone; `aspect` is the picture's width over its height.
/// Spheres are exact: tangents from the eye, and where the near and far planes cut them (after Mara
/// and McGuire, "2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere", 2013). Cones
/// (a sector of the sphere) are exact in front of the near plane, by their apex, the circle of their
/// rim and the cap; cut by it, they are the polyhedron around them. The range must be finite.
class ScreenBoundsOf {
public:
    ScreenBoundsOf(const PlacedCamera& camera, double aspect);
    ScreenBounds operator()(const PlacedLight& light) const;

private:
    const PlacedCamera& camera_;
    double scale_x_, scale_y_; ///< clip space per tangent (perspective) or per metre
};
inline ScreenBounds screen_bounds(const PlacedLight& light, const PlacedCamera& camera, double aspect) {
    return ScreenBoundsOf(camera, aspect)(light);
}

/// The device's record: cut to the picture, with room for what rounding does to pixels and depth.
shared::LightScreenBounds light_bounds(const ScreenBounds& bounds, const shared::FrameConstants& constants,
                                       VkExtent2D extent);

} // namespace prelight::resident
