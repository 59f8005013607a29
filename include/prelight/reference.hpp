#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <prelight/image.hpp>
#include <prelight/renderer.hpp>
#include <vector>

namespace prelight {

/// Which form of the lighting model the reference evaluates (see docs/lighting-model.md).
/// The picture of an implementation is judged against the reference of its own form.
struct ReferenceForm {
    Shading shading = Shading::ggx;
    enum class Fresnel { weighted, nv, mono, full } fresnel = Fresnel::weighted; ///< [ggx] `model=`
    bool mono_specular = false;     ///< [phong]: specular light as luminance (packed light buffer)
    bool grey_reflectance = false;  ///< lights meet F0's luminance (a G-buffer with one specular channel)
    bool gate_by_step = false;      ///< [phong] specular-gate=step: N·L > 0 instead of factor N·L
    bool reflection_vector = false; ///< [phong] specular-vector=reflection: (R·V)^n, not (N·H)^n
    bool ambient_as_light = false;  ///< ambient enters the diffuse sum (full-screen light)
    bool shadows = false;           ///< shadow rays for every light that casts one
    /// Lights see a rougher surface where its normals differ between the pixels of a 2×2 quad, all on the plane of the
    /// triangle that the pixel's own ray hits: α² + min(½(|∂n/∂x|² + |∂n/∂y|²), 0.18). Differences within the
    /// pixel's row and column (Tokuyoshi and Kaplanyan 2019).
    bool specular_antialiasing = false;
    double occlusion_radius = 0; ///< metres: ambient light is occluded by what is nearer; 0: by nothing
    /// Textures: bilinear on level 0, whatever the sampler says; false: as samplers say, with mip maps but for alpha
    /// masks and decals.
    bool bilinear_level0 = true;
    /// [phong] `specular=`: how a material's own exponent comes in. All but `stored` raise a sum
    /// over the lights, and give specular light as luminance.
    enum class Specular { stored, luv, fifth_channel, luminance, bent } specular = Specular::stored;
    /// What materials with a shader of their own make of lights: all at once, as a light buffer sums them;
    /// each by itself, as a forward draw of one light at a time; or, where a G-buffer knows no such shader,
    /// metallic-roughness, with the shader for what needs no light.
    enum class OwnShaders { sums, each_light, no_lights } own_shaders = OwnShaders::sums;
    bool operator==(const ReferenceForm&) const = default;
};

/// What the reference knows of each pixel's first hit, to leave out pixels by `measure.md`'s rule.
struct ReferencePicture {
    Image linear;                     ///< exposed scene-linear
    std::vector<uint32_t> instance;   ///< index into World::instances; 0xffffffff: background
    std::vector<uint32_t> primitive;  ///< primitive within the mesh
    std::vector<glm::dvec3> position; ///< world, of the hit
    /// World: where the point of the surface that the ray hit was at the moment's previous state.
    std::vector<glm::dvec3> previous_position;
    std::vector<glm::dvec3> normal;           ///< shading normal (after the normal map), world, unit
    std::vector<glm::dvec3> geometric_normal; ///< of the triangle, facing the camera
    std::vector<double> depth;                ///< along the camera's axis, metres; infinity: background
    std::vector<uint64_t> shadow_mask;        ///< hash of the outcomes of all shadow rays; 0 when off
    std::vector<uint64_t> mask_outcome;       ///< hash of the alpha tests along the ray; 0: none

    /// One byte per pixel: 1 where a pixel lies beside (8 neighbours) one of another instance,
    /// primitive's alpha mask or shadow outcome, with a normal more than 30° away, or lying off its
    /// plane by more than 1 % of depth.
    std::vector<uint8_t> left_out() const;
};

/// The form that pictures of a renderer with these settings in force (`Stats::settings`) are judged
/// against: `model`, `specular`, `specular-gate`, `specular-vector`, `ambient`, `g-buffer`, `shadows`,
/// `specular-antialiasing`, `texture-filter` (trilinear as samplers say; anisotropy is not modelled). A key that a
/// renderer lacks has its usual meaning (Fresnel of each light, the material's exponent for each light, N·L as a
/// factor, half vector, ambient in the material).
ReferenceForm reference_form(Shading shading, const std::map<std::string, std::string>& settings);

/// Ray-casts the world with Embree, shades in double precision, one ray through each pixel's centre.
/// Deterministic. Throws Error.
ReferencePicture render_reference(const World& world, const PlacedCamera& camera, uint32_t width, uint32_t height,
                                  double exposure, const ReferenceForm& form);

} // namespace prelight
