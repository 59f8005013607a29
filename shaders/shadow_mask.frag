#version 460
#extension GL_GOOGLE_include_directive : require
// Which texels a caster writes in a shadow map: those that an alpha mask leaves, or of a blended surface as many as its
// alpha says, by chance (Enderton, Sintorn, Shirley, Luebke, "Stochastic Transparency", 2010, §3.4).
#include "shared/shadow.h"
#include "shared/shadow_caster.glsl"

layout(push_constant) uniform TileBlock { ShadowTileConstants tile; };
layout(location = 6) flat in uint in_caster;

// PCG (Jarzynski, Olano, "Hash Functions for GPU Rendering", 2020).
uint hash(uint v) {
    uint state = v * 747796405u + 2891336453u, word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

// In each 4×4 texels every sixteenth of 0 … 1 once, in an order of theirs and of the triangle's: layers behind each
// other are independent.
float threshold(uvec2 texel) {
    uint key = hash(in_caster ^ hash(texel.x >> 2 | texel.y >> 2 << 16)), rank = (texel.x & 3u) | (texel.y & 3u) << 2;
    for (uint bits = key, i = 0u; i < 3u; ++i, bits >>= 8) {
        rank = (rank * (bits & 14u | 1u) + (bits >> 4)) & 15u;
        rank ^= rank >> 2;
    }
    return (float(rank) + float(hash(key) >> 8) / 16777216.0) / 16.0;
}

void main() {
    float alpha = caster_alpha();
    bool there = alpha >= material.emissive.w;
    if (has(FEATURE_BLENDED))
        there = alpha > threshold(uvec2(gl_FragCoord.xy) - tile.place.xy);
    if (!there)
        discard;
}
