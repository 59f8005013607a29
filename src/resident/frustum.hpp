#pragma once
#include <array>
#include <glm/mat4x4.hpp>
#include <resident/scene.hpp>

namespace prelight::resident {

/// What a camera or a light's tile sees: the planes of its clip space.
class Frustum {
public:
    /// From world space relative to the point that may_show() is told.
    explicit Frustum(const glm::mat4& clip_from_relative);
    /// True where some of the draw's box may lie in the picture; never false where some of it does. `origin`: world.
    bool may_show(const Draw& draw, const glm::dvec3& origin) const;

private:
    /// A point is in the picture where each `normal` · point + `offset` is ≥ 0: |x| ≤ w, |y| ≤ w, 0 ≤ z ≤ w.
    struct Plane {
        glm::dvec3 normal{0}, size{0}; ///< size: |normal|, component by component
        double offset;
    };
    std::array<Plane, 6> planes_;
};

} // namespace prelight::resident
