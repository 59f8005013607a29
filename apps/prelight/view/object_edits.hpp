#pragma once
#include <map>
#include <prelight/scene.hpp>

namespace prelight::app::viewer {

/// What has been done to the objects of a world, by the numbers of their nodes; laid over it anew at each moment. What
/// hangs below a node in the tree stays where it is.
class ObjectEdits {
public:
    void move(uint32_t node, glm::dvec3 metres) { moved_[node] += metres; }
    /// All but what is as wide as half of the world (grounds, walls) turn, each about the vertical axis through its
    /// middle.
    void turn(double radians);
    bool empty() const { return moved_.empty() && turned_ == 0; }
    void clear() { *this = {}; }
    /// Instances and bounds.
    void apply(World& world) const;

private:
    std::map<uint32_t, glm::dvec3> moved_;
    double turned_ = 0;
};

/// The box of what an instance shows, world.
struct InstanceBox {
    glm::dvec3 low{0}, high{0};
};
InstanceBox box_of(const World& world, const Instance& instance);

/// The next material of the scene that the primitives can carry, for all of a mesh; false: there is no other.
bool take_next_material(Scene& scene, Mesh& mesh);

} // namespace prelight::app::viewer
