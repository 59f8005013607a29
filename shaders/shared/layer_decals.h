// Decals on blended surfaces, which are lit where they are drawn: no buffer holds them, so each object knows its own.
#ifndef PRELIGHT_LAYER_DECALS_H
#define PRELIGHT_LAYER_DECALS_H
#include "shared/decal.h"
SHARED_BEGIN

#define LAYER_DECALS_MOST 4 // on one object

struct LayerDecal {
    DecalConstants box;
    vec4 base_colour;
    vec4 factors;       // metallic, roughness, normal scale, alpha cut-off
    vec4 uv_linear[3];  // of its three textures, as MaterialConstants has them
    vec4 uv_offset[3];
    uvec4 features;     // x: FEATURE_… bits of its material
};

// What of one object, lowest first.
struct LayerDecalList {
    LayerDecal decals[LAYER_DECALS_MOST];
    uvec4 count;        // x
};

SHARED_END
#endif
