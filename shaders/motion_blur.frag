#version 460
#extension GL_GOOGLE_include_directive : require
// Motion blur: at each of some moments of the shutter's time, the surface that was at the pixel then, found where the
// picture shows it now. Two guesses are followed back: that it moves as the pixel's own surface, and that it is
// what moves longest around here (the tiles of McGuire, Hennessy, Bukowski and Osman, "A Reconstruction Filter for Plausible Motion
// Blur", 2012). Where both hold, the nearer one hides the other; where none does, what is there now was hidden then, and
// the farther one is the best guess at what was seen.
#include "shared/motion_blur.glsl"

layout(set = SET_INPUTS, binding = INPUT_COLOUR_BEFORE) uniform PIXEL_IMAGE sharp;
layout(set = SET_INPUTS, binding = INPUT_MOTION_TILES) uniform PIXEL_IMAGE longest_around;
layout(location = 0) out vec4 out_colour;

const int moments = 12;

ivec2 pixel_at(vec2 place) { return clamp(ivec2(floor(place)), ivec2(0), last_pixel()); }

struct Guess {
    ivec2 pixel;
    float depth;  // metres; far where nothing is
    bool holds;   // it was here then
};

Guess follow(vec2 here, float time, vec2 motion) {
    ivec2 first = pixel_at(here + time * motion), pixel = pixel_at(here + time * motion_at(first));
    vec2 off = here + time * motion_at(pixel) - (vec2(pixel) + 0.5);
    bool holds = dot(off, off) < 1.0;
    pixel = holds ? pixel : first; // beyond the surface's edge: what is behind it
    float stored = read_depth(pixel);
    return Guess(pixel, stored > 0.0 ? (linear_depth ? stored : view_depth(stored)) : 3e38, holds);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 own = motion_at(pixel), longest = pixel_read(longest_around, pixel / MOTION_TILE).xy;
    vec4 colour = pixel_read(sharp, pixel);
    out_colour = colour;
    if (dot(longest, longest) < 0.25)
        return;
    // Neighbours look at other moments: 4 × 4 pixels have 16 of them between two of one's own.
    float shift = float((pixel.x & 3) * 4 + ((pixel.y & 1) * 2 + (pixel.y >> 1 & 1))) / 16.0;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < moments; ++i) {
        float time = (float(i) + shift) / float(moments);  // 0: now, 1: when the shutter opened
        vec2 here = vec2(pixel) + 0.5;
        Guess a = follow(here, time, own), b = follow(here, time, longest);
        bool nearer = b.depth < a.depth;
        bool second = a.holds && b.holds ? nearer : a.holds || b.holds ? b.holds : !nearer;
        sum += pixel_read(sharp, second ? b.pixel : a.pixel).rgb;
    }
    out_colour = vec4(sum / float(moments), colour.a);
}
