#pragma once
#include "settings/transparency_settings.hpp"
#include <list>
#include <map>
#include <passes/blended.hpp>
#include <passes/layer_counter.hpp>
#include <passes/lit_layers.hpp>
#include <set>

namespace prelight {

/// Whether an architecture gives each layer of blended surfaces a light pre-pass of its own.
struct LayerLight {
    std::optional<passes::LitLayers::Inputs> inputs = {}; ///< it can
    std::string obstacle = {};                            ///< why it cannot, a phrase
};

/// Tells in the graph's notes what of the scene is drawn opaque and is not: with `why`, what has them so.
void note_what_is_opaque(graph::FrameGraph& graph, const resident::GpuScene& scene, const std::string& why);

/// Tells where decals do not lie on blended surfaces that could have them, for want of the device.
void note_missing_decals(graph::FrameGraph& graph, const resident::GpuScene& scene);
/// Tells of decals that had no room on their object; null: there are none.
void note_left_out_decals(Stats& stats, const resident::LayerDecals* decals);

/// What is drawn over the opaque picture, transmissive and then blended surfaces: the setting `transparency`, the same
/// in every architecture.
class BlendedSurfaces {
public:
    /// Throws UsageError where the setting needs another number of samples, or cannot show single layers.
    BlendedSurfaces(Settings& settings, const gpu::Context& context, const RenderOptions& options);
    /// For GpuSceneSettings::blends.
    bool wanted() const { return transparency_ != Transparency::opaque; }
    /// What a view of the scene needs: the decals of blended objects, and all shadow maps at once.
    void adapt(Settings& settings, resident::ViewSettings& view, const resident::GpuScene& scene) const;
    /// For a graph that is built now: how lights are found. Puts what is in force into the settings, and what is not as
    /// asked for into the graph's notes.
    void choose(Settings& settings, graph::FrameGraph& graph, resident::View& view);
    /// In the graph that is built blended surfaces stand in half of the samples: the architecture draws and lights them
    /// with what is opaque, and add() draws nothing.
    bool in_half_samples() const { return in_half_samples_; }
    /// Before they are drawn into it: counts the layers before `depth`, that of opaque surfaces.
    void count_layers(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth);
    /// A place for a number of draws that tell() adds up.
    uint64_t* count_draws() { return &draws_.emplace_back(0); }
    /// The passes over the linear picture `inputs.colour`; nothing where the scene has no such surface. `inputs`: but
    /// for what all architectures have alike. `lists`: of a grid over the world, where there are any. Puts into the
    /// settings what became of `layer_light`. Returns layer_count_pass()'s image where it is wanted, or there is one.
    std::optional<graph::ImageId> add(graph::FrameGraph& graph, const resident::View& view,
                                      passes::ForwardInputs inputs, const passes::LightLists* lists, Settings& settings,
                                      const LayerLight& layer_light, bool wants_layers);
    /// What "layer=N" of RenderOptions::views shows, by N, in the graph that is built; those that it lacks are black.
    const std::map<uint32_t, graph::ImageId>& shown_layers() const { return shown_layers_; }
    /// Of the last recording, which is done: draws and layers, and in a note what of them is not exact.
    void tell(Stats& stats) const;
    /// Whether the slot's last frame, which is done, had more layers than its graph draws one by one, and another graph
    /// would draw more of them.
    bool outgrown(uint32_t slot) const;
    /// The graph that was built does no more of blended surfaces than count their layers, which nobody has done before:
    /// a frame of it, then take_count(), and another graph draws them.
    bool is_counting() const { return counting_; }
    /// After that frame, which is done.
    void take_count();
    /// Another world comes.
    void forget();

private:
    /// Where layers find their lights.
    struct LayerLights {
        passes::BlendedLights forward;
        std::optional<passes::LitLayers> lit; ///< in the place of the others
    };
    void add_peeled(graph::FrameGraph& graph, const resident::View& view, const passes::ForwardInputs& inputs,
                    LayerLights lights, graph::ImageId layers);
    void add_buffered(graph::FrameGraph& graph, const resident::View& view, const passes::ForwardInputs& inputs,
                      LayerLights lights, graph::ImageId layers);
    /// What lies at `depth`, as "blended layer NUMBER".
    void add_layer(graph::FrameGraph& graph, const resident::View& view, const passes::ForwardInputs& inputs,
                   LayerLights& lights, graph::ImageId depth, uint32_t number);
    std::optional<passes::LitLayers> lit_layers(graph::FrameGraph& graph, const resident::View& view,
                                                Settings& settings, const LayerLight& layer_light) const;
    /// `inputs` with a place of its own for the number of draws.
    passes::ForwardInputs counted(passes::ForwardInputs inputs);
    /// Fills shown_layers(): passes "view-layer …" that peel and shade, whatever draws the picture.
    void show_layers(graph::FrameGraph& graph, const resident::View& view, passes::ForwardInputs inputs,
                     const passes::BlendedLights& lights);
    /// Says in notes and settings how lights are found, where that is not as asked for.
    void choose_lists(Settings& settings, graph::FrameGraph& graph, const resident::View& view);
    std::set<uint32_t> asked_views_; ///< numbers of layers
    std::map<uint32_t, graph::ImageId> shown_layers_;
    Transparency transparency_; ///< asked for
    Transparency taken_;        ///< by the graph that is built
    bool reused_shadows_;       ///< asked for
    bool lists_possible_;       ///< on this device
    uint32_t per_draw_ = 0;
    std::optional<passes::LayerCounter> counter_;
    LightOfLayers asked_light_ = LightOfLayers::lists;
    uint32_t slots_ = 0;                    ///< Transparency::k_buffer
    std::optional<uint32_t> asked_layers_;  ///< none: as many as there are
    std::optional<uint32_t> known_layers_;  ///< of the last frames that were counted
    uint32_t layers_ = 0;                   ///< that the graph draws one by one
    std::optional<graph::ImageId> counted_; ///< count_layers()
    bool counting_ = false, in_half_samples_ = false;
    gpu::SampleShading sample_shading_ = gpu::SampleShading::fragment;
    passes::LightModel model_;
    bool by_lists_ = false;                         ///< of the graph that is built
    const resident::LayerDecals* decals_ = nullptr; ///< of its view
    std::list<uint64_t> draws_;                     ///< of each of its passes
};

} // namespace prelight
