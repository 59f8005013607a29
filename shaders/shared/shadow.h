// Records of shadow maps. Tiles lie side by side in one atlas; a spot has one, a directional light four
// (cascades, the nearest first), a point light or a wide spot six (+x −x +y −y +z −z).
#ifndef PRELIGHT_SHADOW_H
#define PRELIGHT_SHADOW_H
#include "shared/interop.h"
SHARED_BEGIN

#define SHADOW_SPOT 0
#define SHADOW_CASCADES 1
#define SHADOW_FACES 2

// LightData::shadow, and frame.sun.x: the number of a light's first tile plus 1, times this, and SHADOW_…; 0: no shadow.
#define SHADOW_KINDS 4u

// What lighting knows of one tile. Its first three are rows of a matrix over (x, y, z, 1), camera-relative world. A
// software device pays for each member that a filter reads.
struct ShadowData {
    vec4 across; // texels of the tile × w
    vec4 down;   // likewise
    vec4 away;   // w; of cascades, whose w is 1, depth
    vec4 place;  // xy: the tile's corner in the atlas, texels; z: its side; w: largest radius of the filter, texels
    vec4 scale;  // metres that a texel covers: x + y · w; z: metres from depth 0 to depth 1 (cascades), else 0;
                 // w: depth × w (near plane), metres
    vec4 ends;   // cascades: view depths where they end
    vec4 light;  // x: size of the light: metres, or metres per metre (cascades)
};
#define SHADOW_TEXELS 7 // members, as texels

// Push constants of a tile that is drawn.
struct ShadowTileConstants {
    mat4 clip_from_centre; // world relative to the world's centre → the tile's clip space; reversed depth
    uvec4 place;           // xy: the tile's corner in the atlas, texels
};

SHARED_END
#endif
