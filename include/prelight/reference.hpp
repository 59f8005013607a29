#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <prelight/export.hpp>
#include <prelight/glm_defaults.hpp>
#include <prelight/image.hpp>
#include <prelight/renderer.hpp>
#include <vector>

namespace prelight {

/// Several samples a pixel, at Vulkan's standard sample positions, and what is evaluated how often. A fragment is what
/// one triangle owns of a pixel: its samples that see the triangle. What is evaluated once a fragment is so where the
/// ray through the pixel's centre meets the triangle's plane, on the triangle or beyond its edges. Textures are
/// filtered with the neighbouring pixels' rays through the same place of the pixel.
struct ReferenceSamples {
    uint32_t count =
        1; ///< one of sample_counts; the only one goes through the pixel's centre, and nothing else here matters then
    /// Where light is evaluated: the sums of all lights, and ambient occlusion.
    enum class Light {
        sample,   ///< at each sample; where materials are evaluated once a fragment they meet the mean of its samples'
        pixel,    ///< once for all of the pixel's materials: see below
        edges,    ///< likewise where a pixel's samples share a surface; else once for those that share light
        fragment, ///< once a fragment, as forward renderers do
    };
    Light light = Light::sample; ///< as Light says
    /// How often something is evaluated.
    enum class Rate {
        sample,   ///< at each sample
        fragment, ///< once a fragment
    };
    Rate material = Rate::sample; ///< surface and background colours, and what becomes of the light
    /// What lights see of surfaces but for their position: normal and roughness. Of surfaces with an alpha mask always
    /// each sample's, as are alpha tests.
    Rate geometry = Rate::sample;
    /// Samples share a surface only if it is of one colour, as far as a G-buffer tells.
    bool colours_apart = false;
    /// A light's shadow is that at the pixel's one place, for all its samples; at their own where the light does not
    /// reach that place, or its surface turns away from it. Not on layers.
    bool shadows_per_pixel = false;
    /// [Transparency::layers] Surfaces that are blended, all of them: colour, alpha, light.
    Rate layers = Rate::sample;
    // The one place of a pixel: where its samples share a surface, that under its centre, at the mean of their device
    // depths if they hit several triangles; else the surface of the first sample that has one, at that sample's depth
    // under the centre. Samples share a surface where all have one whose normals meet at a cosine of 0.99 or more,
    // whose roughness differs by at most a twentieth, and whose view depth differs from the first one's by at most
    // (1 + 2 tan) times the width of a pixel there; tan is that of the angle between the first one's normal and the
    // view, at most 10. Of the others those share light that do so at a cosine of 0.9995 and a hundredth, at the mean
    // of their places and device depths, with the first one's normal.

    /// Member by member.
    bool operator==(const ReferenceSamples&) const = default;
};

/// Which form of the lighting model the reference evaluates (see docs/lighting-model.md).
/// The picture of an implementation is judged against the reference of its own form.
struct ReferenceForm {
    Shading shading = Shading::ggx; ///< the lighting model
    /// [ggx] Where Fresnel's reflectance comes from: the setting `model` (docs/lighting-model.md).
    enum class Fresnel {
        weighted, ///< the mean over the lights, weighted by their light
        nv,       ///< of the angle between normal and viewer
        mono,     ///< weighted, with specular light as luminance
        full,     ///< of each light
    };
    Fresnel fresnel = Fresnel::weighted; ///< as Fresnel says
    bool mono_specular = false;          ///< [phong]: specular light as luminance (packed light buffer)
    bool grey_reflectance = false;       ///< lights meet F0's luminance (a G-buffer with one specular channel)
    bool gate_by_step = false;           ///< [phong] specular-gate=step: N·L > 0 instead of factor N·L
    bool reflection_vector = false;      ///< [phong] specular-vector=reflection: (R·V)^n, not (N·H)^n
    bool ambient_as_light = false;       ///< ambient enters the diffuse sum (full-screen light)
    bool shadows = false;                ///< shadow rays for every light that casts one
    /// Lights see a rougher surface where its normals differ between the pixels of a 2×2 quad, all on the plane of the
    /// triangle that the pixel's own ray hits: α² + min(½(|∂n/∂x|² + |∂n/∂y|²), 0.18). Differences within the
    /// pixel's row and column (Tokuyoshi and Kaplanyan 2019).
    bool specular_antialiasing = false;
    double occlusion_radius = 0; ///< metres: ambient light is occluded by what is nearer; 0: by nothing
    /// Textures: bilinear on level 0, whatever the sampler says; false: as samplers say, with mip maps but for alpha
    /// masks and decals.
    bool bilinear_level0 = true;
    /// [phong] How a material's own exponent comes in: the setting `specular` (docs/lighting-model.md). All but
    /// `stored` raise a sum over the lights, and give specular light as luminance.
    enum class Specular {
        stored,        ///< in each light, from the stored exponent
        luv,           ///< `specular=luv`
        fifth_channel, ///< `specular=fifth-channel`
        luminance,     ///< `specular=luminance`
        bent,          ///< `specular=bent`
    };
    Specular specular = Specular::stored; ///< as Specular says
    /// What materials with a shader of their own make of lights.
    enum class OwnShaders {
        sums,       ///< all at once, as a light buffer sums them
        each_light, ///< each by itself, as a forward draw of one light at a time
        no_lights,  ///< as a G-buffer that knows no such shader: metallic-roughness, the shader for what needs no light
    };
    OwnShaders own_shaders = OwnShaders::sums; ///< as OwnShaders says
    /// What surfaces with AlphaMode::blend are.
    enum class Transparency {
        opaque, ///< opaque, and so is what light comes through (transmits())
        /// Layers that let through 1 − α of what is behind them. Nothing but their own light knows of them; they
        /// occlude no ambient light. What light comes through shows the opaque picture behind it as
        /// docs/transmission.md has it, and throws no shadow.
        layers,
    };
    Transparency transparency = Transparency::opaque; ///< as Transparency says
    /// [Transparency::layers, four samples] Samples 1 and 2 show the nearest layer that has an alpha of 1/16 or more
    /// there, as if it were opaque, all of it at each sample but for the light; the others show none. Then the layer of
    /// each is laid over the other sample of its half of the pixel, and both show that. Where something is
    /// transmissive, layers are as without.
    bool half_samples = false;
    /// [Transparency::layers] The layers' shadows.
    enum class TransparentShadows {
        opaque,   ///< as of what is opaque
        filtered, ///< Π(1 − α) of the light comes through
        none,     ///< none
    };
    TransparentShadows transparent_shadows = TransparentShadows::filtered; ///< as TransparentShadows says
    /// Inferred lighting (docs/inferred.md): lights are evaluated at this share of the picture's width and height, for
    /// what is opaque and for up to three layers, and pixels find them there by their surface. 0: at each pixel; else
    /// 1/8 … 1, with one sample a pixel and another Fresnel than `full`.
    double inferred_scale = 0;
    ReferenceSamples samples{}; ///< of a pixel
    /// Member by member.
    bool operator==(const ReferenceForm&) const = default;
};

/// A blended surface in front of what a pixel's ray hits; the last one may be transmissive.
struct ReferenceLayer {
    uint32_t instance = 0;                ///< as ReferencePicture::instance
    uint32_t primitive = 0;               ///< as ReferencePicture::primitive
    double depth = 0;                     ///< as ReferencePicture::depth
    double alpha = 0;                     ///< 0 … 1
    glm::dvec3 position{0};               ///< as ReferencePicture::position
    glm::dvec3 normal{0, 0, 1};           ///< as ReferencePicture::normal
    glm::dvec3 geometric_normal{0, 0, 1}; ///< as ReferencePicture::geometric_normal
    uint64_t shadow_mask = 0;             ///< as ReferencePicture::shadow_mask
};

/// What the reference knows of each pixel's first opaque hit, of sample 0 where there are several; with the pixels that
/// its pictures cannot judge (docs/measuring.md).
struct ReferencePicture {
    Image linear;                     ///< exposed scene-linear; the mean of a pixel's samples
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
    std::vector<uint32_t> layer_count;        ///< layers of each pixel; empty: there are none in the picture
    std::vector<ReferenceLayer> layers;       ///< of all pixels in order, each pixel's nearest first

    uint32_t samples = 1; ///< a pixel; of one the vectors that follow are empty, but for `doubts` of inferred lighting
    /// Exposed scene-linear, `samples` a pixel in Vulkan's order. Samples of a fragment share what is evaluated once.
    std::vector<glm::vec3> sample_colours;
    /// 1 where a pixel's samples see more than one surface: another instance or primitive, or the background, or a
    /// normal or plane that left_out() calls another.
    std::vector<uint8_t> edge;
    /// Why a pixel is left out.
    enum Doubt : uint8_t {
        near_edge = 1, ///< a ray 1/128 pixel beside a sample's, across or down, sees another surface
        shadow = 2,    ///< samples of one surface, here and in the pixels beside this one, differ in shadows
        mask = 4,      ///< samples, here and in the pixels beside this one, differ in alpha tests
        sharing = 16,  ///< samples share a surface or light, or almost: see ReferenceSamples
        inferred =
            32, ///< a texel of the light that counts is near an edge or a shadow's, or whether it counts is close
        extrapolated = 8, ///< the pixel's centre is before no part of a fragment's plane; one of its samples serves
    };
    std::vector<uint8_t> doubts; ///< sums of Doubt

    /// Display-encoded sRGB: the mean of the tone-mapped samples in the display's linear light, then encoded. An edge
    /// between a lamp and the night comes out half as bright as the lamp shows, and not as bright as the lamp.
    PRELIGHT_API Image display(Tonemap curve) const;

    /// 1 where `doubts` has any; with several samples a pixel an edge by itself is none. With one sample besides:
    /// one byte per pixel: 1 where a pixel lies beside (8 neighbours) one of another instance,
    /// primitive's alpha mask or shadow outcome, with a normal more than 30° away, or lying off its
    /// plane by more than 1 % of depth; or where that is so of their first layers, their second ones and so on, or one
    /// has more of them.
    PRELIGHT_API std::vector<uint8_t> left_out() const;
};

/// The form that pictures of a renderer with these settings in force (`Stats::settings`) are judged
/// against: `model`, `specular`, `specular-gate`, `specular-vector`, `ambient`, `g-buffer`, `shadows`,
/// `specular-antialiasing`, `texture-filter` (trilinear as samplers say; anisotropy is not modelled). A key that a
/// renderer lacks has its usual meaning (Fresnel of each light, the material's exponent for each light, N·L as a
/// factor, half vector, ambient in the material).
/// `transparency`: BLEND is opaque in a renderer that lacks it or says so, and layers with every other value, however
/// they are drawn; with four samples `half-samples` is a form of its own; `transparent-shadows`. Layers of several
/// samples a pixel are evaluated once a fragment unless `msaa-layers` says otherwise. `inferred-scale` (1, 3/4, 5/8,
/// 1/2) and `inferred-layers`, of the renderer `inferred`. `samples`: a pixel. With several: `msaa-light`,
/// `msaa-material` and `msaa-shadows`, each per sample unless it says otherwise; `msaa-geometry`, which renderers on a
/// device lack, for they store a normal once a fragment. A renderer without `msaa-light` is a forward one: all once a
/// fragment, unless `msaa-material` says per sample.
PRELIGHT_API ReferenceForm reference_form(Shading shading, const std::map<std::string, std::string>& settings,
                                          uint32_t samples = 1);

/// Ray-casts the world with Embree and shades in double precision. Deterministic. Throws Error, also for a number of
/// samples other than 1, 2 and 4.
PRELIGHT_API ReferencePicture render_reference(const World& world, const PlacedCamera& camera, uint32_t width,
                                               uint32_t height, double exposure, const ReferenceForm& form);

} // namespace prelight
