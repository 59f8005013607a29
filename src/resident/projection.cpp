#include "projection.hpp"
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace prelight::resident {
namespace {

/// clip.z = −scale · view depth + offset, so that near gives 1 and far 0 after division by w.
struct DepthMap {
    double scale, offset;
};

DepthMap depth_map(const Camera& camera) {
    const double n = camera.znear, f = camera.zfar;
    if (camera.kind == ProjectionKind::orthographic)
        return {1 / (f - n), f / (f - n)};
    return std::isinf(f) ? DepthMap{0, n} : DepthMap{n / (f - n), n * f / (f - n)};
}

glm::dmat4 view_of(const glm::dmat3& axes) {
    return glm::transpose(
        glm::dmat4(glm::dvec4(axes[0], 0), glm::dvec4(axes[1], 0), glm::dvec4(axes[2], 0), glm::dvec4(0, 0, 0, 1)));
}

} // namespace

void fill_camera(shared::FrameConstants& constants, const PlacedCamera& placed, uint32_t width, uint32_t height) {
    const Camera& camera = placed.camera;
    const bool perspective = camera.kind == ProjectionKind::perspective;
    const double half_height = perspective ? std::tan(camera.yfov / 2) : camera.ymag;
    const double half_width = half_height * width / height;
    const glm::dvec3 right = placed.axes[0], up = placed.axes[1], forward = -placed.axes[2];
    const DepthMap map = depth_map(camera);

    const glm::dmat4 view = view_of(placed.axes);
    // View z is negative in front of the camera.
    glm::dmat4 clip(0);
    clip[0][0] = 1 / half_width;
    clip[1][1] = -1 / half_height;
    clip[2][2] = map.scale;
    clip[3][2] = map.offset;
    clip[2][3] = perspective ? -1 : 0;
    clip[3][3] = perspective ? 0 : 1;

    constants.clip_from_world = glm::mat4(clip * view);
    constants.previous_clip_from_world = constants.clip_from_world;
    if (placed.previous) {
        const glm::dvec3 moved = placed.position - placed.previous->position;
        const glm::dmat4 previous = view_of(placed.previous->axes) * glm::translate(glm::dmat4(1), moved);
        constants.previous_clip_from_world = glm::mat4(clip * previous);
    }
    constants.world_from_clip = glm::mat4(glm::inverse(clip * view));
    constants.view_from_world = glm::mat4(view);
    constants.ray_right = glm::vec4(right * half_width, 0);
    constants.ray_up = glm::vec4(-up * half_height, 0);
    constants.forward = glm::vec4(forward, perspective ? 1 : 0);
    constants.depth = glm::vec4(map.scale, map.offset, 0, 0);
}

} // namespace prelight::resident
