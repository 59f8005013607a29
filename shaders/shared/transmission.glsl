// What comes through a transmissive surface (docs/transmission.md): of the picture behind it, and of lamps behind it. Part of
// forward_light.glsl with TRANSMISSION, where the material is `layered`.
#ifndef PRELIGHT_TRANSMISSION_GLSL
#define PRELIGHT_TRANSMISSION_GLSL
#include "shared/behind.glsl"

layout(location = 6) flat in float in_scale; // metres that a unit of the mesh is

// What is left of a roughness for light that comes through: a body that does not bend light does not blur what is behind it
// either.
float roughness_through(float roughness) { return roughness * clamp(2.0 * ior - 2.0, 0.0, 1.0); }

// Where a point appears, pixels. One beside or behind the camera: far outside.
vec2 pixel_of(vec3 world) {
    vec4 clip = frame.clip_from_world * vec4(world, 1.0);
    return (clip.xy / max(clip.w, 1e-6) * 0.5 + 0.5) * raster.size.xy;
}

// What the light keeps on its way through the body.
vec3 transmittance(float metres) { return exp(log(max(attenuation_colour, vec3(1e-6))) * (metres / attenuation_distance)); }

float body_depth(Point p) { return thickness_at(p) * in_scale; }

// The picture behind the point, exposed, before the body takes its share.
vec3 picture_behind(Point p, Surface s) {
    float bend = 1.0 / ior, cosine = clamp(dot(s.normal, p.to_viewer), 0.0, 1.0);
    vec3 into = normalize((bend * cosine - sqrt(1.0 - bend * bend * (1.0 - cosine * cosine))) * s.normal - bend * p.to_viewer);
    // As a difference: a thin wall shows its own pixel, without rounding.
    vec2 moved = pixel_of(p.position + body_depth(p) * into) - pixel_of(p.position);
    float longer = max(raster.size.x, raster.size.y), blur = roughness_through(metallic_roughness(p).y);
    return behind(gl_FragCoord.xy + moved, log2(1.0 + longer * (exp2(10.0 * blur) - 1.0) / 1023.0));
}

// `point` as lamps behind it light it: mirrored at the surface, with the viewer on their side of it.
LitPoint lit_through(LitPoint point, float lamp_roughness, vec2 pixel) {
    vec3 viewer = point.v - 2.0 * point.nv * point.n;
    return lit_point(true, point.world, -point.n, viewer, max(roughness_through(lamp_roughness), 0.089), pixel);
}

// Where a surface with alphaMode BLEND does not cover the picture, it is seen as it is: also one that others of its kind
// are in front of.
vec3 over_picture(vec3 colour, float alpha) {
    return has(FEATURE_BLENDED) ? mix(behind(floor(gl_FragCoord.xy) + 0.5, 0.0), colour, alpha) : colour;
}
#endif
