#pragma once
#include "settings/transparency_settings.hpp"
#include <passes/blended.hpp>

namespace prelight {

/// What is drawn over the opaque picture: the setting `transparency`, the same in every architecture.
class BlendedSurfaces {
public:
    BlendedSurfaces(Settings& settings, const gpu::Context& context);
    /// For GpuSceneSettings::blends.
    bool wanted() const { return transparency_ != Transparency::opaque; }
    /// What a view of the scene needs: all shadow maps at once.
    void adapt(Settings& settings, resident::ViewSettings& view, const resident::GpuScene& scene) const;
    /// For a graph that is built now: how lights are found. Puts what is in force into the settings, and what is not as
    /// asked for into the graph's notes.
    void choose(Settings& settings, graph::FrameGraph& graph, resident::View& view);
    /// The pass over the linear picture `inputs.colour`; nothing where the scene has no blended surface. `inputs`: but
    /// for what all architectures have alike. `lists`: of a grid over the world, where there are any.
    void add(graph::FrameGraph& graph, const resident::View& view, passes::ForwardInputs inputs,
             const passes::LightLists* lists);
    /// Of the last recording: draws, and in a note what of them is not exact.
    void tell(Stats& stats) const;

private:
    Transparency transparency_;
    bool reused_shadows_; ///< asked for
    uint32_t per_draw_ = 0;
    gpu::SampleShading sample_shading_ = gpu::SampleShading::fragment;
    passes::LightModel model_;
    bool by_lists_ = false; ///< of the graph that is built
    uint64_t draws_ = 0;
};

} // namespace prelight
