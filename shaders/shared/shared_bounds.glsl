// Bounds of a coarse cell's lights, one in each invocation of a subgroup.
#ifndef PRELIGHT_SHARED_BOUNDS_GLSL
#define PRELIGHT_SHARED_BOUNDS_GLSL
#include "shared/light_cells.glsl"
#include "shared/light_share.glsl"

struct SharedBounds {
    uint light;
    uint depths;
    LightBounds bounds;
};

// The lights of the list from `begin` on.
SharedBounds load_bounds(LightCell coarse, uint begin) {
    SharedBounds own;
    // A list of none stands nowhere: light 0 instead.
    uint at = coarse.count > 0u ? coarse.first + min(begin + gl_SubgroupInvocationID, coarse.count - 1u) : 0u;
    uint light = light_entries[at];
    own.light = coarse.count > 0u ? light : 0u;
    own.bounds = bounds_of(lights[own.light]);
    own.depths = depths_of(own.bounds);
    return own;
}

// What invocation `lane` has loaded.
SharedBounds shared_bounds(SharedBounds own, uint lane) {
    LightBounds b = LightBounds(shuffled(own.bounds.centre, lane), subgroupShuffle(own.bounds.radius, lane),
                                shuffled(own.bounds.axis, lane), shuffled(own.bounds.cone, lane));
    return SharedBounds(subgroupShuffle(own.light, lane), subgroupShuffle(own.depths, lane), b);
}

bool reaches(SharedBounds light, LightCell cell, Piece piece) {
    return holds_depths(cell, light.depths) && touches(piece, light.bounds);
}
#endif
