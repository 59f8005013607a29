#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <reference/ray_scene.hpp>
#include <span>

namespace prelight::reference {

/// Places are within a pixel, from its top left.
inline constexpr glm::dvec2 pixel_centre{0.5, 0.5};

/// Vulkan's standard sample positions ("Multisampling" in its specification); of one sample the pixel's centre.
/// `count`: one of sample_counts.
inline std::span<const glm::dvec2> sample_positions(uint32_t count) {
    static constexpr std::array one{pixel_centre};
    static constexpr std::array two{glm::dvec2(0.75, 0.75), glm::dvec2(0.25, 0.25)};
    static constexpr std::array four{glm::dvec2(0.375, 0.125), glm::dvec2(0.875, 0.375), glm::dvec2(0.125, 0.625),
                                     glm::dvec2(0.625, 0.875)};
    return count == 1 ? std::span<const glm::dvec2>(one) : count == 2 ? std::span<const glm::dvec2>(two) : four;
}

/// Rays through a picture, relative to the camera's position. A ray's direction has length 1 along the camera's axis,
/// so that distances along a ray are depths.
class Lens {
public:
    /// `aspect`: width ÷ height of what the camera sees, where pixels are not square; 0: they are.
    Lens(const PlacedCamera& placed, uint32_t width, uint32_t height, double aspect = 0)
        : placed_(placed), width_(width), height_(height) {
        const Camera& camera = placed.camera;
        half_height_ = camera.kind == ProjectionKind::perspective ? std::tan(camera.yfov / 2) : camera.ymag;
        half_width_ = aspect > 0 ? half_height_ * aspect : half_height_ * width / height;
    }

    Ray ray(uint32_t x, uint32_t y, glm::dvec2 place) const {
        const Camera& camera = placed_.camera;
        const double across = (2 * (x + place.x) / width_ - 1) * half_width_;
        const double up = (1 - 2 * (y + place.y) / height_) * half_height_;
        const glm::dvec3 offset = placed_.axes[0] * across + placed_.axes[1] * up;
        if (camera.kind == ProjectionKind::perspective)
            return {glm::dvec3(0), offset - placed_.axes[2], camera.znear, camera.zfar};
        return {offset, -placed_.axes[2], camera.znear, camera.zfar};
    }

    /// Metres that a pixel covers across the view at this depth.
    double pixel(double depth) const { return 2 * half_height_ / height_ * (perspective() ? depth : 1); }

    /// Of a place relative to the camera: along the camera's axis, metres.
    double depth(const glm::dvec3& place) const { return -glm::dot(placed_.axes[2], place); }
    /// Where it shows: pixels from the left and upper edge; of one beside or behind the camera, far outside.
    glm::dvec2 place_of(const glm::dvec3& place) const {
        const double scale = perspective() ? std::max(depth(place), 1e-6) : 1;
        return {(glm::dot(placed_.axes[0], place) / (scale * half_width_) + 1) / 2 * width_,
                (1 - glm::dot(placed_.axes[1], place) / (scale * half_height_)) / 2 * height_};
    }

    /// Pixels.
    double longer_side() const { return std::max(width_, height_); }

    bool perspective() const { return placed_.camera.kind == ProjectionKind::perspective; }

private:
    const PlacedCamera& placed_;
    double width_, height_, half_width_ = 1, half_height_ = 1;
};

} // namespace prelight::reference
