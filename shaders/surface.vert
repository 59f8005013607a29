#version 460
#extension GL_GOOGLE_include_directive : require
// variants: MOTION|SHADOW_TILE|SURFACE_IDS, NO_WORLD, NO_NORMAL, NO_TEXTURES
// never: MOTION NO_WORLD, MOTION NO_NORMAL, MOTION NO_TEXTURES, SHADOW_TILE NO_WORLD, SHADOW_TILE NO_NORMAL, SHADOW_TILE NO_TEXTURES
#ifdef SHADOW_TILE
#define NO_WORLD
#define NO_NORMAL
#endif
#include "shared/surface_vertex.glsl"
