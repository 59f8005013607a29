#pragma once
#include <gpu/shader_key.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace prelight {

/// What a shader's first comments say about its variants, beside #version and #extension:
///
///     // variants: ONE_TARGET|COUNT_TARGET, SHADOWS     one of the first two or none, and SHADOWS or not
///     // never: COUNT_TARGET SHADOWS, …                 these do not come together
///     // only: OCCLUSION with OWN_MATERIAL, …           not without the other
///     // only: SAMPLES with DECALS|SOFT                 not without one of the others
///     // materials: all with OWN_MATERIAL, blinn_phong with ONLY_WEIGHTED, only layered with OWN_MATERIAL TRANSMISSION
///
/// `materials`: whose surfaces the shader is compiled with beside metallic_roughness; with "all", instead of it; with
/// "only", instead of all others.
struct ShaderAxes {
    struct Pair {
        std::string what;
        gpu::Variants with;
        bool alone = false; ///< "only"
    };
    std::vector<std::vector<gpu::Variants>> choices; ///< of each axis, the first of them none
    std::vector<gpu::Variants> never;
    std::vector<std::pair<gpu::Variants, std::vector<gpu::Variants>>> only; ///< what, with one of what
    std::vector<Pair> materials;
};

/// Throws std::runtime_error: a line that is not as above.
ShaderAxes read_axes(std::string_view source);

/// Every shader that the axes allow. `materials`: the names that "all" stands for.
std::vector<gpu::ShaderKey> all_keys(const std::string& file, const ShaderAxes& axes,
                                     const std::vector<std::string>& materials);

} // namespace prelight
