// Records of shadow maps. Tiles lie side by side in one atlas; a spot has one, a directional light four
// (cascades, the nearest first), a point light or a wide spot six (+x −x +y −y +z −z).
#ifndef PRELIGHT_SHADOW_H
#define PRELIGHT_SHADOW_H
#include "shared/interop.h"
SHARED_BEGIN

#define SHADOW_SPOT 0
#define SHADOW_CASCADES 1
#define SHADOW_FACES 2

// What lighting knows of one tile. LightData::shadow says which is a light's first.
struct ShadowData {
    mat4 texel_from_world; // camera-relative world → texels of the tile × w, depth × w, w
    vec4 place;  // xy: the tile's corner in the atlas, texels; z: its side; w: largest radius of the filter, texels
    vec4 texel;  // metres that a texel covers: x + y · w; zw: 1 / size of the atlas
    vec4 ends;   // cascades: view depths where they end
    vec4 source; // x: metres from depth 0 to depth 1 (cascades), else 0; y: depth × w (near plane), metres;
                 // z: size of the light: metres, or metres per metre (cascades); w: SHADOW_…
};

// Push constants of a tile that is drawn.
struct ShadowTileConstants {
    mat4 clip_from_centre; // world relative to the world's centre → the tile's clip space; reversed depth
    uvec4 place;           // xy: the tile's corner in the atlas, texels
};

SHARED_END
#endif
