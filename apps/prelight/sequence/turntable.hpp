#pragma once
#include <prelight/scene.hpp>

namespace prelight::app {

/// A camera that goes round a scene's vertical axis, through the centre of its bounds, counter-clockwise seen from
/// above, as azimuths count. One that stands in a room, a
/// courtyard or a street turns on the spot.
class Turntable {
public:
    /// `seconds` > 0: one round. `start`: the camera at time 0; its distance from the axis, its height and what it
    /// looks at from there stay. `widen`: near and far plane move so far apart that nothing of the world is cut off
    /// on the way round; for a camera whose planes suit its first place only.
    Turntable(const World& world, const PlacedCamera& start, double seconds, bool widen);
    /// The same camera at a time, seconds; with where it was `interval` seconds earlier. At time 0 exactly as it began.
    PlacedCamera at(double time, double interval) const;

private:
    CameraPose pose_at(double time) const;

    PlacedCamera start_;
    glm::dvec3 centre_{0};
    double seconds_;
};

} // namespace prelight::app
