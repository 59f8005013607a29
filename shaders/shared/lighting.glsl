// One light on one surface point: falloff, the terms that a light buffer sums, and what a material
// makes of them.
#ifndef PRELIGHT_LIGHTING_GLSL
#define PRELIGHT_LIGHTING_GLSL
#include "shared/frame.glsl"
#include "shared/light_distribution.glsl"
#include "shared/light_kinds.glsl"
#include "shared/shininess.glsl"
#include "shared/reflectance.glsl"
#ifdef SHADOWS
#include "shared/shadows.glsl"
#endif

layout(constant_id = CONSTANT_SHADING) const int shading = SHADING_GGX;
layout(constant_id = CONSTANT_SPECULAR_STEP_GATE) const bool specular_step_gate = false;
layout(constant_id = CONSTANT_REFLECTION_VECTOR) const bool reflection_vector = false;
layout(constant_id = CONSTANT_SPECULAR_WAY) const int specular_way = SPECULAR_STORED;

#ifdef SHADOWS_ELSEWHERE
layout(constant_id = CONSTANT_SHADOWS_AT_PIXEL) const bool shadows_at_pixel = false; // for all samples of it
#endif

// A surface point as lights see it, with everything that no light changes.
struct LitPoint {
    bool surface;     // something is there to be lit
    vec3 world, n, v; // camera-relative world space; n and v are unit vectors; n is 0 without a surface
    float nv;         // N·V, of either sign
    float alpha2;     // [ggx] roughness⁴
    float lobe;       // [ggx] what of D V no light changes: α² / (π (N·V + √(α² + (1 − α²) N·V²)))
    float shininess;  // [phong] the material's exponent
#ifdef SHADOWS
    vec2 turn;        // of the disc that shadows are filtered with
    uint sun;         // the shadow (as in LightSource) that needs no maps, for it is known here; 0: there is none
    float sunlit;     // what comes past it
    float unhidden;   // [LightSource::shadow_known] what comes past the maps of the light at hand
#ifdef SHADOWS_ELSEWHERE
    vec3 shadow_world, shadow_n; // [shadows_at_pixel] where shadows are looked up, as world and n
#endif
#endif
};

// `roughness` is at least 0.089; `pixel`: gl_FragCoord.xy.
LitPoint lit_point(bool surface, vec3 world, vec3 n, vec3 v, float roughness, vec2 pixel) {
    LitPoint p;
    p.surface = surface;
    p.world = world;
    p.n = surface ? n : vec3(0.0);
    p.v = v;
    p.nv = dot(n, v);
    p.alpha2 = p.lobe = 0.0;
    p.shininess = 1.0;
#ifdef SHADOWS
    p.turn = disc_turn(pixel);
    p.sun = 0u;
    p.sunlit = p.unhidden = 1.0;
#ifdef SHADOWS_ELSEWHERE
    p.shadow_world = p.shadow_n = vec3(0.0);
#endif
#endif
    if (shading == SHADING_GGX) {
        p.alpha2 = roughness * roughness * roughness * roughness;
        float nv = max(p.nv, 1e-4);
        p.lobe = p.alpha2 / (3.14159265 * (nv + sqrt(p.alpha2 + (1.0 - p.alpha2) * nv * nv)));
    } else if (specular_way == SPECULAR_STORED) {
        p.shininess = shininess(roughness); // only way 1 knows the material here
    }
    return p;
}

// A light as points are lit by it, with everything that no point changes.
struct LightSource {
    vec4 position;         // xyz: as in LightData; w: 0 of a directional light, else 1
    vec3 colour;
    float luminance;       // of colour
    float inverse_range2;  // 1 / range², 0 when infinite
    vec3 axis;             // of a spot
    vec2 cone;
    float shininess;
    uint falloff;          // LIGHT_FALLOFF_…
    uint distribution;     // number of its DistributionData from 1, 0 without one
#ifdef SHADOWS
    uint shadow;           // as in LightData
    uint shadow_kind;      // SHADOW_…, of it
    bool shadow_known;     // it was looked up: LitPoint::unhidden
#endif
};

LightSource light_source(LightData light) {
    float at_a_point = (light.kind & LIGHT_DIRECTIONAL) == 0u ? 1.0 : 0.0;
    return LightSource(vec4(light.position, at_a_point), light.colour, luminance(light.colour),
                light.inverse_range * light.inverse_range, light.axis, light.cone, light.shininess,
                light.kind & LIGHT_FALLOFF_MASK, light.kind >> LIGHT_DISTRIBUTION_SHIFT
#ifdef SHADOWS
                , light.shadow, light.shadow % SHADOW_KINDS, false
#endif
    );
}

// KHR_lights_punctual: clamp(1 − (d/range)⁴, 0, 1) / max(d, 0.01 m)², times the cone. `d2` is the squared
// distance, `inverse` 1 / d, `l` the unit vector to the light; for a directional light the result is 1.
float attenuation(LightSource source, float d2, float inverse, vec3 l) {
    float x2 = d2 * source.inverse_range2;
    float falloff = max(1.0 - x2 * x2, 0.0) * min(inverse * inverse, 1e4);
    if (may_be(LIGHT_KIND_OTHER_FALLOFF)) {
        float linear = clamp(1.0 - sqrt(x2), 0.0, 1.0);
        float quadratic = clamp(1.0 - x2, 0.0, 1.0);
        falloff = source.falloff == LIGHT_FALLOFF_LINEAR      ? linear
                  : source.falloff == LIGHT_FALLOFF_QUADRATIC ? quadratic
                                                            : falloff;
    }
    if (may_be(LIGHT_KIND_SPOT)) {
        float cone = clamp(-dot(source.axis, l) * source.cone.x + source.cone.y, 0.0, 1.0);
        falloff *= cone * cone;
    }
    return falloff;
}

// The weight of 1 − F0 in Schlick's reflectance.
float schlick_weight(float cosine) {
    float m = clamp(1.0 - cosine, 0.0, 1.0);
    float m2 = m * m;
    return m2 * m2 * m;
}

// How a light gets to a point.
struct Reach {
    vec3 to_light;
    float inverse;    // 1 / distance
    vec3 l;           // unit vector
    float attenuation;
    float nl;         // N·L, at least 0
    bool contributes; // attenuation and N·L are above zero
};

Reach reach(LightSource source, LitPoint p) {
    Reach r;
    r.to_light = source.position.xyz - p.world * (may_be(LIGHT_KIND_DIRECTIONAL) ? source.position.w : 1.0);
    float d2 = dot(r.to_light, r.to_light);
    r.inverse = inversesqrt(max(d2, 1e-12));
    r.l = r.to_light * r.inverse;
    r.attenuation = attenuation(source, d2, r.inverse, r.l);
    r.nl = clamp(dot(p.n, r.l), 0.0, 1.0);
    r.contributes = r.attenuation > 0.0 && r.nl > 0.0;
    return r;
}

#ifdef SHADOWS
// Where shadows of a light are looked up for a point, and how it gets there.
struct ShadowPoint {
    vec3 world, n;
    Reach reach;
};

ShadowPoint shadow_point(LightSource source, LitPoint p, Reach r) {
    ShadowPoint at = ShadowPoint(p.world, p.n, r);
#ifdef SHADOWS_ELSEWHERE
    if (shadows_at_pixel) { // but for lights that do not get there, whose maps have nothing to say of it
        p.world = p.shadow_world;
        p.n = p.shadow_n;
        Reach there = reach(source, p);
        at.world = there.contributes ? p.world : at.world;
        at.n = there.contributes ? p.n : at.n;
        at.reach.to_light = there.contributes ? there.to_light : r.to_light;
        at.reach.nl = there.contributes ? there.nl : r.nl;
    }
#endif
    return at;
}

LightShadow shadow_of(LightSource source) { return LightShadow(source.shadow, source.shadow_kind, source.axis); }
bool is_stored_sun(LightSource source, LitPoint p) { return p.sun > 0u && source.shadow == p.sun; }

// What of the light comes past its shadow casters.
float unhidden(LightSource source, LitPoint p, Reach r, bool wanted) {
    ShadowPoint at = shadow_point(source, p, r);
    return unshadowed(shadow_of(source), at.world, at.n, -at.reach.to_light, at.reach.nl, p.turn, wanted);
}
#endif

// What one light sends to a surface point, before the material's colours come in: factors of its colour.
struct LightTerms {
    float diffuse;      // N·L att
    float specular;     // [ggx] N·L att D V; [phong] gate att (N·H)^n
    float vh;           // V·H
    bool contributes;   // attenuation and N·L are above zero, in shadow or not
};

// The half vector H is never made: with |L + V|² = 2 + 2 L·V, N·H = (N·L + N·V) / |L + V| and
// V·H = |L + V| / 2. That saves a software device a third of the loop. `source` comes out with the colour that it sends to
// this point.
LightTerms light_terms(inout LightSource source, LitPoint p) {
    Reach r = reach(source, p);
    vec3 l = r.l;
    float att = r.attenuation, nl = r.nl;
    bool contributes = r.contributes;
    if (may_be(LIGHT_KIND_DISTRIBUTION)) {
        if (contributes && source.distribution > 0u)
            source.colour *= light_distribution(source.distribution, -l, pixel_on_surface(p.world, p.nv) * r.inverse);
        source.luminance = luminance(source.colour);
    }
#ifdef SHADOWS
    bool sun = is_stored_sun(source, p);
    float comes = source.shadow_known ? p.unhidden : unhidden(source, p, r, contributes && !sun);
    att *= sun ? p.sunlit : comes;
#endif
    float lv = dot(l, p.v);
    float half2 = max(2.0 + 2.0 * lv, 1e-12);  // |L + V|²
    float nh = max(nl + p.nv, 0.0);            // times |L + V|
    float diffuse = att * nl;
    float specular;
    if (shading == SHADING_GGX) {
        // glTF 2.0, appendix B: Trowbridge-Reitz D times separable Smith visibility V. With f = (N·H)² (α² − 1) + 1,
        // D = α² / (π f²); f is held at its least value α², for cancellation could make it less.
        float f = max(half2 - (1.0 - p.alpha2) * nh * nh, p.alpha2 * half2); // times |L + V|²
        float d = half2 / f;
        float smith = nl + sqrt(p.alpha2 + (1.0 - p.alpha2) * nl * nl);
        specular = diffuse * p.lobe * d * d / smith;
    } else {
        float base = reflection_vector ? 2.0 * nl * p.nv - lv : nh * inversesqrt(half2);
        float gate = specular_step_gate ? (nl > 0.0 ? att : 0.0) : diffuse;
        specular = gate * pow(clamp(base, 1e-6, 1.0), source.shininess * p.shininess);
    }
    return LightTerms(diffuse, specular, 0.5 * sqrt(half2), contributes);
}

// What a surface sends on to the viewer; `schlick` weighs 1 − F0 ([ggx] only).
vec3 reflected(LightSource source, LightTerms terms, Reflectance r, float schlick) {
    if (shading == SHADING_PHONG)
        return source.colour * (r.diffuse * terms.diffuse + r.f0 * terms.specular);
    vec3 fresnel = r.f0 + (1.0 - r.f0) * schlick;
    return source.colour * (r.diffuse * (1.0 - fresnel) * (terms.diffuse / 3.14159265) + fresnel * terms.specular);
}
#endif
