#pragma once
#include "lighting.hpp"
#include "materials.hpp"
#include "screen_lists.hpp"

namespace prelight::passes {

/// Layers of blended surfaces, each with a light pre-pass of its own: normals and depths of what lies at one depth a
/// pixel, all lights into the light buffer, and the materials over the picture. Normals, depths and light buffer are
/// one layer's, and every next one's in turn.
class LitLayers {
public:
    struct Inputs {
        LightModel model; ///< is_pair_of_halves()
        bool specular_antialiasing = false;
        Shadows shadows; ///< of all lights at once
        const gpu::Buffer* pair_counters = nullptr;
        bool count_pairs = false;
        bool wide = false; ///< make_light_buffer()
        ScreenListOptions lists;
    };
    /// View::culling() knows lists, and surfaces have one sample a pixel.
    LitLayers(graph::FrameGraph& graph, const resident::View& view, const Inputs& inputs);
    /// Passes "NAME normal", those of light lists, "NAME light", and "NAME" which blends what lies at `depth` over
    /// `colour`, a scene-linear picture. `drawn` gets the number of draws of the last.
    void add(graph::FrameGraph& graph, const resident::View& view, const std::string& name, graph::ImageId depth,
             graph::ImageId colour, uint64_t* drawn);

private:
    Inputs inputs_;
    SurfaceFormat format_;
    graph::ImageId normal_, linear_depth_;
    LightBuffer light_;
};

} // namespace prelight::passes
