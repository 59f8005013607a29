#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// Calls `change(list)` for each list of the primitive that has one element a vertex, but for its
/// tangents: what reorders vertices or repeats them must do it to all. Lists may be empty.
template <class Change>
void for_vertex_lists(Primitive& primitive, Change change) {
    change(primitive.positions);
    change(primitive.normals);
    change(primitive.colours);
    for (auto& set : primitive.texcoords)
        change(set);
    for (JointSet& set : primitive.joint_sets) {
        change(set.joints);
        change(set.weights);
    }
    for (MorphTarget& target : primitive.morph_targets) {
        change(target.positions);
        change(target.normals);
        change(target.tangents);
    }
}

} // namespace prelight
