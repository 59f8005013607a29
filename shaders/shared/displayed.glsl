// The finished picture as passes after tone mapping read and write it: its values as the eye takes them (sRGB-encoded),
// to find edges by; linear ones, to mix. An sRGB image is decoded and encoded by the device, any other one here.
#ifndef PRELIGHT_DISPLAYED_GLSL
#define PRELIGHT_DISPLAYED_GLSL
#include "shared/display.glsl"

vec3 displayed_encoded(vec3 stored) { return target_encodes ? srgb_encode(stored) : stored; }
vec4 displayed_linear(vec4 stored) { return target_encodes ? stored : vec4(srgb_decode(stored.rgb), stored.a); }
vec4 displayed_stored(vec4 linear) { return target_encodes ? linear : vec4(srgb_encode(linear.rgb), linear.a); }
#endif
