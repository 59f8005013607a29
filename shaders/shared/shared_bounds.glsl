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

// Whether the light that invocation `lane` has loaded may reach the cell.
bool reaches(SharedBounds own, uint lane, LightCell cell, Piece piece) {
    LightBounds b = LightBounds(shuffled(own.bounds.centre, lane), subgroupShuffle(own.bounds.radius, lane),
                                shuffled(own.bounds.axis, lane), shuffled(own.bounds.cone, lane));
    return holds_depths(cell, subgroupShuffle(own.depths, lane)) && touches(piece, b);
}
#endif
