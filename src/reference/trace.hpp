#pragma once
#include <map>
#include <prelight/reference.hpp>

namespace prelight::reference {

/// What one sample of each pixel sees.
struct SampleSurfaces {
    std::vector<double> depth;      ///< as of ReferencePicture
    std::vector<glm::dvec3> normal; ///< likewise
};

/// What `ReferenceRenderer` shows beside the picture; all linear, and but for layers not exposed.
struct ReferenceBuffers {
    Image albedo;                 ///< base colour
    Image diffuse_light;          ///< LightSums::diffuse
    Image specular_light;         ///< LightSums::specular
    Image visibility;             ///< of ambient light, in all three channels; empty unless visibility_radius says so
    double visibility_radius = 0; ///< metres, to be set before: how far surfaces occlude; 0: do not look
    /// Of layers by number, to be named before: α times their light, as `curve` displays it, the mean of the samples.
    std::map<uint32_t, Image> layers;
    /// Of samples by number, to be named before.
    std::map<uint32_t, SampleSurfaces> samples;
    Tonemap curve = Tonemap::pbr_neutral;
    std::vector<uint32_t> light_count; ///< lights with attenuation and N·L above zero, unblocked
};

/// `render_reference`, which also fills `buffers` when it is given.
ReferencePicture trace(const World& world, const PlacedCamera& camera, uint32_t width, uint32_t height, double exposure,
                       const ReferenceForm& form, ReferenceBuffers* buffers = nullptr);

} // namespace prelight::reference
