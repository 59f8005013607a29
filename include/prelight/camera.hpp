#pragma once
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <prelight/export.hpp>
#include <prelight/glm_defaults.hpp>
#include <string>

namespace prelight {

/// How a camera maps space to the picture.
enum class ProjectionKind { perspective, orthographic };

/// A projection as glTF gives it. The camera looks along its −Z axis, +Y is up.
/// The picture's own width/height decides the horizontal extent; the vertical one stays.
struct Camera {
    std::string name;                                      ///< of the file; may be empty
    ProjectionKind kind = ProjectionKind::perspective;     ///< which of the members below count
    double yfov = 0.87;                                    ///< radians, full vertical angle, 0 … π (perspective)
    double ymag = 1;                                       ///< metres, half the height of the view (orthographic)
    double znear = 0.1;                                    ///< metres, > 0 for perspective, ≥ 0 for orthographic
    double zfar = std::numeric_limits<double>::infinity(); ///< metres; infinite: perspective only
};

/// Where a camera stands and looks.
struct CameraPose {
    glm::dvec3 position{0}; ///< world, metres
    glm::dmat3 axes{1};     ///< as PlacedCamera::axes
};

/// A camera placed in the world.
struct PlacedCamera {
    Camera camera;                        ///< its projection
    glm::dvec3 position{0};               ///< world, metres
    glm::dmat3 axes{1};                   ///< columns: right, up, backwards (+Z); orthonormal, world space
    std::optional<CameraPose> previous{}; ///< at the moment's previous state; absent: did not move
};

/// Camera at `eye` looking at `target`; `up` need not be orthogonal.
PRELIGHT_API PlacedCamera look_at(const Camera& camera, glm::dvec3 eye, glm::dvec3 target, glm::dvec3 up = {0, 1, 0});

} // namespace prelight
