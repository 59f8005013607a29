#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/bindings.h"
#include "shared/raster.h"
// The bits of the samples that hold 1, and what the pass knows of its raster.
layout(set = 0, binding = 0) uniform texture2DMS four;
layout(set = 0, binding = INPUT_RASTER, std140) uniform RasterBlock { RasterConstants raster; };
layout(location = 0) out vec4 result;

void main() {
    float bits = 0.0;
    for (int i = 0; i < 4; ++i)
        bits += exp2(float(i)) * texelFetch(four, ivec2(gl_FragCoord.xy), i).r;
    result = vec4(bits, raster.size.xy, raster.size.x * raster.size.z);
}
