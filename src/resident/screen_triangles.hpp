#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/mat4x4.hpp>

namespace prelight::resident {

/// A triangle whose corners share one of the first six bits is off screen.
enum OutsideBits : uint32_t {
    outside_left = 1,
    outside_right = 2,
    outside_top = 4,
    outside_bottom = 8,
    outside_near = 16,
    outside_far = 32,
    /// Behind the camera, or so far off that single precision does not tell where: its triangles are kept.
    unknown_place = 64,
};

constexpr float farthest = 16384; ///< pixels from the picture's corner

/// How an object's vertices get onto the screen, and how sure that is.
struct ScreenPlacing {
    glm::mat4 clip{1};       ///< object → clip space
    glm::vec4 error{0};      ///< what the device's rounding and ours may differ by in clip space
    glm::vec2 slack{0};      ///< the same in x and y, of sides of the picture: with w's part
    glm::vec2 beyond{1};     ///< so many w from the middle no rounding brings a vertex back into the picture
    glm::vec2 half_size{0};  ///< of the picture, pixels
    float least_exact_w = 0; ///< nearer than this, places are not exact to a 256th of a pixel
};

/// Vertices on the screen, each number by itself.
struct ScreenVertices {
    float* x = nullptr; ///< pixels; 0 where unknown
    float* y = nullptr;
    uint32_t* outside = nullptr; ///< OutsideBits; null for select_triangles(): none of them
};

void place_vertices(const ScreenPlacing& placing, const glm::vec3* positions, size_t count, const ScreenVertices& out);

/// Which triangles may show.
struct TriangleTest {
    float margin = 0; ///< pixels that a vertex may be off where the device sees it
    float reach = 0;  ///< pixels from a pixel's centre to its samples, along each axis
    float facing = 0; ///< sign of the area, clockwise as y points down, of those that show; 0: both
};

constexpr uint32_t most_triangles = 64; ///< of one select_triangles()

/// Writes the indices of what may show of the next `triangles` to `out`, which has room for all; returns how many.
size_t select_triangles(const TriangleTest& test, const uint32_t* indices, uint32_t triangles,
                        const ScreenVertices& vertices, uint32_t* out);

} // namespace prelight::resident
