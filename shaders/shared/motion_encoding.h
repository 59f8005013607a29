// Motion vectors: how far a point of a surface has moved over the picture since the previous state, in
// pixels, right and down positive. The same text is compiled as C++ and as GLSL.
#ifndef PRELIGHT_MOTION_ENCODING_H
#define PRELIGHT_MOTION_ENCODING_H
#include "shared/interop.h"
SHARED_BEGIN

#define MOTION8_RANGE 64.0f  // pixels

// For half floats: finite whatever happened, e.g. a point that passed the camera's plane.
SHARED_FUNCTION vec2 motion_clamp(vec2 pixels) {
    return clamp(pixels, vec2(-65504.0f, -65504.0f), vec2(65504.0f, 65504.0f));
}

// For 8-bit unsigned normalised channels: 128 is no motion, 1 and 255 are 64 pixels; in between, the
// signed square root, so that a step is 0.004 pixels at rest and 1 pixel at the range's end. What is
// longer keeps its direction.
SHARED_FUNCTION vec2 motion8_encode(vec2 pixels) {
    vec2 p = motion_clamp(pixels) / MOTION8_RANGE;
    p = p / max(max(abs(p.x), abs(p.y)), 1.0f);
    return (sign(p) * sqrt(abs(p)) * 127.0f + 128.0f) / 255.0f;
}

SHARED_FUNCTION vec2 motion8_decode(vec2 stored) {
    vec2 s = (floor(stored * 255.0f + 0.5f) - 128.0f) / 127.0f;
    return sign(s) * s * s * MOTION8_RANGE;
}

SHARED_END
#endif
