#pragma once
#include <prelight/camera.hpp>
#include <prelight/scene.hpp>

namespace prelight::app::viewer {

// Orbit and fly cameras, each a function from where the camera is to where it is next. Nothing here knows of time,
// windows or pixels: what a drag or a step amounts to is the caller's to say.

/// A camera and the point that it goes round.
struct Rig {
    PlacedCamera camera;
    double distance = 1; ///< metres from the camera to the pivot, along its axis; > 0

    glm::dvec3 forward() const { return -camera.axes[2]; }
    glm::dvec3 pivot() const { return camera.position + distance * forward(); }
};

/// A place in the picture: −1 … 1 from left to right and from bottom to top.
struct PicturePoint {
    double x = 0, y = 0;
    double aspect = 1; ///< the picture's width / height
};

/// The camera as it is; it will go round what lies before it at the middle of the world's depth.
Rig rig_of(const PlacedCamera& camera, const World& world);
/// Looks along the same axis at all of the world.
Rig framed(const Rig& rig, const World& world, double aspect);

/// Round the pivot: `yaw` about +Y, counter-clockwise seen from above, `pitch` upwards; radians. It does not tip over.
Rig orbited(const Rig& rig, double yaw, double pitch);
/// Round the camera's own place.
Rig looked(const Rig& rig, double yaw, double pitch);
/// Along with the picture: by shares of its height, right and up, at the pivot's distance.
Rig panned(const Rig& rig, double right, double up);
/// Nearer by `notches` of a wheel, each a tenth of the way, to what lies at `to` in the pivot's plane.
Rig dollied(const Rig& rig, double notches, const PicturePoint& to);
/// Metres along the camera's right, world up and the camera's forward.
Rig flown(const Rig& rig, glm::dvec3 metres);

/// A ray through a place of the picture.
struct Ray {
    glm::dvec3 origin{0}, direction{0, 0, -1}; ///< world; unit
};
Ray ray_through(const PlacedCamera& camera, const PicturePoint& point);
/// Where a world point is in the picture; absent: behind the camera.
std::optional<PicturePoint> projected(const PlacedCamera& camera, glm::dvec3 world, double aspect);

} // namespace prelight::app::viewer
