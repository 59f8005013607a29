// Records of shadow maps. Tiles lie side by side in one atlas; a spot has one, a directional light four
// (cascades, the nearest first), a point light or a wide spot six (+x −x +y −y +z −z).
#ifndef PRELIGHT_SHADOW_H
#define PRELIGHT_SHADOW_H
#include "shared/bindings.h"
#include "shared/interop.h"
SHARED_BEGIN

#define SHADOW_SPOT 0
#define SHADOW_CASCADES 1
#define SHADOW_FACES 2

// LightData::shadow, and frame.sun.x: the number of a light's first tile plus 1, times this, and SHADOW_…; 0: no shadow.
#define SHADOW_KINDS 4u

// Texels along an edge of a cell, of which the image of extremes has one texel.
#define SHADOW_CELL 2

// Depth × w of spots and faces, metres: the near plane. Depth is near / w in floats, so that it costs no precision.
#define SHADOW_NEAR 0.002f

// What lighting knows of one tile. A software device pays for each member that a lookup reads: spots and faces need
// the first alone (with `contact` the size of the light, too), for their axes follow from the light's, or from the face.
struct ShadowData {
    vec4 place;  // xy: the tile's corner in the atlas, texels; z: its side; w: spots and faces: texels for each metre
                 // across the axis, one metre along it
    vec4 scale;  // z: size of the light: metres, or metres per metre (cascades); of cascades also x: metres that a texel
                 // covers; y: metres from depth 0 to depth 1
    // Cascades; rows of a matrix over (x, y, z, 1), camera-relative world:
    vec4 across; // texels of the tile
    vec4 down;   // likewise
    vec4 away;   // depth
    vec4 ends;   // view depths where the light's cascades end
};
#define SHADOW_TEXELS 6 // members, as texels

// How many texels on each edge of a tile lie outside of what it is asked for: the filter's disc, half a texel of
// filtering, and what the bias moves a point by. `filtering`: SHADOW_FILTER_…; `side`: of the tile.
SHARED_FUNCTION uint shadow_guard(uint filtering, uint side) {
    uint wanted = filtering == SHADOW_FILTER_HARD ? 3u : filtering == SHADOW_FILTER_PCF ? 6u : 24u;
    return min(wanted, side / 4u);
}

// The largest radius of the filter in it, texels.
SHARED_FUNCTION float shadow_radius(uint filtering, uint side) {
    return min(filtering == SHADOW_FILTER_CONTACT ? 10.0f : 1.5f, float(shadow_guard(filtering, side)) / 2.0f);
}

// Which face of a cube around a light a direction goes through.
struct CubeFace {
    bool x, y;     // across which axis; neither: z
    float towards; // 1, or −1 towards the axis's negative end
};

SHARED_FUNCTION CubeFace cube_face(vec3 direction) {
    vec3 size = abs(direction);
    CubeFace face;
    face.x = size.x >= size.y && size.x >= size.z;
    face.y = !face.x && size.y >= size.z;
    face.towards = (face.x ? direction.x : face.y ? direction.y : direction.z) < 0.0f ? -1.0f : 1.0f;
    return face;
}

// Among the light's tiles: +x −x +y −y +z −z.
SHARED_FUNCTION uint number_of(CubeFace face) {
    return (face.x ? 0u : face.y ? 2u : 4u) + (face.towards < 0.0f ? 1u : 0u);
}

// A vector along the axes of the face's tile: right, up, forward.
SHARED_FUNCTION vec3 along_face(CubeFace face, vec3 v) {
    return face.x   ? vec3(face.towards * v.z, -v.y, face.towards * v.x)
           : face.y ? vec3(-face.towards * v.z, -v.x, face.towards * v.y)
                    : vec3(-face.towards * v.x, -v.y, face.towards * v.z);
}

// Axes of a spot's tile, beside its own. Both the plan of maps and lighting derive them, so they may jump only where
// both see it alike: at z = 0 (Duff and others, "Building an Orthonormal Basis, Revisited", 2017).
SHARED_FUNCTION vec3 spot_right(vec3 axis) {
    float s = axis.z >= 0.0f ? 1.0f : -1.0f, a = -1.0f / (s + axis.z);
    return vec3(1.0f + s * axis.x * axis.x * a, s * axis.x * axis.y * a, -s * axis.x);
}
SHARED_FUNCTION vec3 spot_up(vec3 axis) {
    float s = axis.z >= 0.0f ? 1.0f : -1.0f, a = -1.0f / (s + axis.z);
    return vec3(axis.x * axis.y * a, s + axis.y * axis.y * a, -axis.y);
}

// Push constants of a tile that is drawn.
struct ShadowTileConstants {
    mat4 clip_from_centre; // world relative to the world's centre → the tile's clip space; reversed depth
    uvec4 place;           // xy: the tile's corner in the atlas, texels
};

SHARED_END
#endif
