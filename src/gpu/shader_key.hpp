#pragma once
#include <compare>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace prelight::gpu {

/// Macros that shaders are compiled with, for what a specialisation constant cannot do: an output or input that is not
/// there, another type of texture. Those that a shader knows stand at its top, after "// variants:"; the build makes
/// every combination that is allowed there (tools/compile_shaders), and no other.
#define PRELIGHT_VARIANTS(X)                                                                                           \
    X(one_target, "ONE_TARGET")               /* sums of light: Engel's four channels */                               \
    X(light_pair, "LIGHT_PAIR")               /* diffuse and specular light as the bits of one texel */                \
    X(light_bits, "LIGHT_BITS")               /* half floats of light read as bits: Pass::sample_bits() */             \
    X(count_target, "COUNT_TARGET")           /* counts of lights instead of light */                                  \
    X(deferred_target, "DEFERRED_TARGET")     /* light of the surface's own material */                                \
    X(added, "ADDED")                         /* a compute pass adds to what stands in its target */                   \
    X(shadows, "SHADOWS")                     /* reads shadow maps */                                                  \
    X(stencil_roughness, "STENCIL_ROUGHNESS") /* roughness lies in stencil */                                          \
    X(roughness_target, "ROUGHNESS_TARGET")   /* in a target of its own */                                             \
    X(depth_target, "DEPTH_TARGET")           /* linear depth in a colour target */                                    \
    X(no_normal_target, "NO_NORMAL_TARGET")                                                                            \
    X(decals, "DECALS")             /* reads the decal buffer */                                                       \
    X(layer_decals, "LAYER_DECALS") /* knows the decals of a blended object itself */                                  \
    X(occlusion, "OCCLUSION")       /* ambient light is occluded */                                                    \
    X(only_weighted, "ONLY_WEIGHTED")                                                                                  \
    X(own_material, "OWN_MATERIAL") /* compiled with one of shaders/materials/, or a user's */                         \
    X(grid_cells, "GRID_CELLS")     /* light lists: cells in the world */                                              \
    X(by_depth, "BY_DEPTH")                                                                                            \
    X(samples, "SAMPLES")           /* images of the frame hold several samples a pixel */                             \
    X(sample_light, "SAMPLE_LIGHT") /* edge pixels' samples have light of their own */                                 \
    X(wide_slots, "WIDE_SLOTS")     /* of the sample light buffer: more than two million */                            \
    X(textured, "TEXTURED")                                                                                            \
    X(motion, "MOTION")                                                                                                \
    X(shadow_tile, "SHADOW_TILE")         /* a caster, as a light sees it */                                           \
    X(no_world, "NO_WORLD")               /* no point, no normal, no texture coordinates from the vertex shader */     \
    X(weighted, "WEIGHTED")               /* sums for weighted blended transparency */                                 \
    X(transmission, "TRANSMISSION")       /* what is behind comes through */                                           \
    X(surface_ids, "SURFACE_IDS")         /* inferred lighting: writes ids of surfaces, or finds light by them */      \
    X(layer, "LAYER")                     /* of a blended object, in a slot of the texels */                           \
    X(beyond_k_buffer, "BEYOND_K_BUFFER") /* of them those behind a k-buffer's layers */                               \
    X(facing, "FACING")                   /* vertices stand from their positions in the viewer's plane */              \
    X(soft, "SOFT")                       /* fades before what is opaque behind it */                                  \
    X(no_normal, "NO_NORMAL")                                                                                          \
    X(no_textures, "NO_TEXTURES")

enum class Variant : uint8_t {
#define PRELIGHT_VARIANT(name, macro) name,
    PRELIGHT_VARIANTS(PRELIGHT_VARIANT)
#undef PRELIGHT_VARIANT
};

inline constexpr std::string_view variant_macros[] = {
#define PRELIGHT_VARIANT(name, macro) macro,
    PRELIGHT_VARIANTS(PRELIGHT_VARIANT)
#undef PRELIGHT_VARIANT
};

static_assert(std::size(variant_macros) <= 64);

/// A set of them.
class Variants {
public:
    constexpr Variants() = default;
    constexpr Variants(Variant one) : bits_(uint64_t(1) << static_cast<uint32_t>(one)) {}
    constexpr bool has(Variant one) const { return (bits_ & Variants(one).bits_) != 0; }
    constexpr bool has_all(Variants all) const { return (bits_ & all.bits_) == all.bits_; }
    constexpr bool empty() const { return bits_ == 0; }
    constexpr uint64_t bits() const { return bits_; }
    constexpr static Variants from_bits(uint64_t bits) {
        Variants out;
        out.bits_ = bits;
        return out;
    }
    constexpr friend Variants operator|(Variants a, Variants b) { return from_bits(a.bits_ | b.bits_); }
    constexpr Variants& operator|=(Variants more) { return *this = *this | more; }
    constexpr auto operator<=>(const Variants&) const = default;
    std::vector<std::string_view> macros() const {
        std::vector<std::string_view> out;
        for (size_t v = 0; v < std::size(variant_macros); ++v)
            if (has(static_cast<Variant>(v)))
                out.push_back(variant_macros[v]);
        return out;
    }

private:
    uint64_t bits_ = 0;
};
constexpr Variants operator|(Variant a, Variant b) { return Variants(a) | Variants(b); }
/// The variants where `on`, else none.
constexpr Variants when(bool on, Variants variants) { return on ? variants : Variants(); }

/// Which SPIR-V: a file of shaders/, what it is compiled with, and whose surfaces it shades.
struct ShaderKey {
    std::string file; ///< "light.frag"; empty: no shader
    Variants variants;
    std::string material; ///< a file of shaders/materials/ without ".glsl", or a user's; empty: metallic_roughness

    ShaderKey() = default;
    ShaderKey(const char* name, Variants with = {}, std::string of = {})
        : file(name), variants(with), material(std::move(of)) {}
    ShaderKey(std::string name, Variants with = {}, std::string of = {})
        : file(std::move(name)), variants(with), material(std::move(of)) {}
    bool empty() const { return file.empty(); }
    ShaderKey with(Variants more) const { return {file, variants | more, material}; }
    /// "light.frag ONE_TARGET SHADOWS", for messages and debug names.
    std::string text() const {
        std::string out = material.empty() ? file : material + "/" + file;
        for (const std::string_view macro : variants.macros())
            (out += ' ') += macro;
        return out;
    }
    auto operator<=>(const ShaderKey&) const = default;
};

} // namespace prelight::gpu
