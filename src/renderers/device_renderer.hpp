#pragma once
#include "blended_surfaces.hpp"
#include "frame_queue.hpp"
#include "frame_stats.hpp"
#include "light_sums.hpp"
#include "own_passes.hpp"
#include "pair_counters.hpp"
#include "post_filter.hpp"
#include "settings/settings.hpp"
#include <functional>
#include <graph/frame_graph.hpp>
#include <memory>
#include <optional>
#include <passes/sample_surfaces.hpp>
#include <passes/shadow_maps.hpp>
#include <passes/tonemap.hpp>
#include <resident/view.hpp>

namespace prelight {

/// What every architecture on a Vulkan device has in common: it takes a world in, builds its frame
/// graph once, records it once a frame, and keeps the figures. An architecture adds its passes.
/// render() comes back while frames are still in flight; whatever needs their end waits for it.
class DeviceRenderer : public Renderer {
public:
    void set_world(const World& world) final;
    void share_world(const Renderer& other) final;
    const World* world() const final { return world_; }
    void update_world(const WorldChanges& changes) final;
    void set_lights(std::span<const PlacedLight> lights) final;
    void resize(uint32_t width, uint32_t height) final;
    void render(const PlacedCamera& camera, uint32_t frames) final;
    Image read(std::string_view view) final;
    Texels texels(std::string_view view) final;
    Stats stats() const final;
    /// A buffer of the last frame where it lies, for a window: valid until the next call of anything that is not const.
    /// The frame may still be in flight; later submissions to the device's queue come after it. Throws as read() does.
    gpu::ShownImage shown(std::string_view view) const;
    /// vulkan::render_into(), add_pass() and remove_pass().
    void render_into(const PlacedCamera& camera, const vulkan::Target& target);
    uint64_t add_pass(vulkan::Pass pass);
    void remove_pass(uint64_t number);
    /// Figures of the last frame that is known to be done, without waiting for one.
    const FrameFigures& last_frame() { return queue_->last_frame(); }
    /// Every setting with the value in force: Stats::settings, without waiting.
    std::map<std::string, std::string> settings_in_force() const { return settings_.all(); }
    uint64_t max_lights() const final { return context_.limits().maxStorageBufferRange / sizeof(shared::LightData); }

protected:
    /// Waits for the frames in flight: for destructors of what owns objects that they use.
    void finish() noexcept;
    /// Throws UsageError and Error (a picture larger than the device can make).
    DeviceRenderer(Device& device, const RenderOptions& options, Settings settings);
    /// Images that read() gives, by view name; "final" among them.
    using Outputs = std::map<std::string, graph::ImageId, std::less<>>;
    /// The architecture: its passes, in order.
    virtual Outputs build(graph::FrameGraph& graph, const resident::View& view) = 0;
    /// Whether the graph that is built with `before` lights is the one for `lights`, too.
    virtual bool draws_as_many(size_t /*before*/, size_t /*lights*/) const { return true; }
    /// How often blending may add light to one pixel; 0: no half floats are blended.
    virtual uint32_t blended_adds(const resident::View&) const { return 0; }
    /// What that takes, for build().
    const LightSums& light_sums() const { return light_sums_; }
    /// The picture from `linear`, which is kept when it was asked for; where the depth of `surface` is empty, the
    /// background; over both, blended surfaces. `filter` makes another scene-linear picture of the whole. `surface`
    /// without normals: they are its depth.
    Outputs linear_outputs(graph::FrameGraph& graph, const resident::View& view, graph::ImageId linear,
                           const passes::SurfaceBuffers& surface,
                           const std::function<graph::ImageId(graph::ImageId)>& filter = {});
    /// The picture from `draw`, which draws it finished or scene-linear: finished, unless "linear" was
    /// asked for or something is blended. That saves an image of 8 bytes a pixel and a pass.
    Outputs picture_outputs(graph::FrameGraph& graph, const resident::View& view, const passes::SurfaceBuffers& surface,
                            const std::function<graph::ImageId(passes::Display)>& draw);
    /// The lists of a grid over the world, in an architecture that builds some for the graph that is built.
    virtual const passes::LightLists* world_lists() const { return nullptr; }
    /// What it takes to light layers of blended surfaces as opaque ones are, in an architecture with a light buffer.
    virtual LayerLight layer_light(graph::FrameGraph&, const resident::View&) {
        return {.obstacle = "there is no light buffer"};
    }
    virtual resident::GpuSceneSettings scene_settings() const;
    virtual resident::ViewSettings view_settings() const;
    /// Where lights are evaluated at another resolution: what the view is made of that they are evaluated for. Shadow
    /// maps are that view's then, and the picture's view has none.
    virtual std::optional<resident::ViewSettings> light_view_settings() const { return {}; }
    /// That view, or the picture's.
    const resident::View& light_view() const { return light_view_ ? *light_view_ : *view_; }
    /// Stats::draws of the last frame.
    virtual uint64_t draws(const resident::View& view) const { return view.visible().batches.size(); }

    /// What an architecture alone knows of the last frame, which is done.
    virtual void add_figures(Stats&) const {}

    const gpu::Context& context() const { return context_; }
    const RenderOptions& options() const { return options_; }
    const Settings& settings() const { return settings_; }
    bool wants(std::string_view view) const;
    /// The pass of shadow maps, counted for stats(); call it before the passes that evaluate lights. One for a graph.
    const passes::Shadows& shadows(graph::FrameGraph& graph, const resident::View& view) {
        return shadows_ ? *shadows_ : shadows_.emplace(passes::shadow_pass(graph, view, shadow_counts_));
    }
    /// passes::sampled_surfaces() as `msaa-light` says; with one sample a pixel `surface` and `colours` as they are.
    passes::SampledSurfaces sampled(graph::FrameGraph& graph, const resident::View& view,
                                    const passes::SurfaceBuffers& surface, passes::GBufferColours* colours = nullptr);
    /// The program's own passes of a stage; `surface` without normals: they are its depth. `more`: what else there is.
    void own_passes(vulkan::Stage stage, graph::FrameGraph& graph, const resident::View& view,
                    const passes::SurfaceBuffers& surface, std::vector<OwnPasses::Offered> more = {});
    const OwnPasses& own_passes() const { return own_passes_; }
    const gpu::Buffer& pair_counters() const { return pair_counters_->buffer(); }
    /// For an architecture that draws blended surfaces in half of the samples.
    BlendedSurfaces& blended() { return blended_; }
    const BlendedSurfaces& blended() const { return blended_; }

    /// Samples of depth and normals by themselves, where that was asked for.
    void add_surface_samples(Outputs& outputs, graph::FrameGraph& graph, const resident::View& view,
                             const passes::SurfaceBuffers& surface) const;

private:
    /// set_world(), with what is on the device already. Null: nothing is.
    void take_world(const World& world, std::shared_ptr<resident::GpuScene> scene);
    /// update_world(). Throws Error, and has taken in some of it.
    void take_changes(const WorldChanges& changes);
    /// How many layers there are, and single ones, where that was asked for. `layers`: none where nothing is blended.
    void add_layers_views(Outputs& outputs, graph::FrameGraph& graph, const resident::View& view,
                          const passes::SurfaceBuffers& surface, const std::optional<graph::ImageId>& layers) const;
    /// Samples of the picture by themselves, where that was asked for. `curve`: of a picture that is linear.
    void add_picture_samples(Outputs& outputs, graph::FrameGraph& graph, const resident::View& view,
                             graph::ImageId picture, passes::Display curve) const;
    /// Throws Error.
    void check_size(uint32_t width, uint32_t height) const;
    /// Of a pixel. Throws UsageError for a number that no renderer knows, Error for one that the device lacks.
    void check_samples(uint32_t samples) const;
    void make_view();
    /// Of the picture, and of the lights where they have their own.
    template <class Do>
    void each_view(const Do& act) {
        act(*view_);
        if (light_view_)
            act(*light_view_);
    }
    void update_views(const PlacedCamera& camera, uint32_t slot = 0) {
        each_view([&](resident::View& view) { view.update(camera, slot); });
    }
    /// View, counters and graph for pictures of this size. Throws Error, and has taken down some of them.
    void remake_view(uint32_t width, uint32_t height);
    /// Waits for all frames and lets the graph go.
    void drop_graph();
    void build_graph();
    void warm_up(const PlacedCamera& camera);
    /// Before the first frame of a world whose blended surfaces are drawn layer by layer: finds out how many there are.
    void count_layers(const PlacedCamera& camera);
    void render(const PlacedCamera& camera, uint32_t frames, const vulkan::Target* target);
    void render_frame(const PlacedCamera& camera, const vulkan::Target* target);
    /// One more frame, pass by pass: adds each pass's CPU time to costs_.
    void time_passes(const PlacedCamera& camera);
    void build_again();
    /// Throws UsageError.
    void check_target(const vulkan::Target& target) const;
    static graph::ExternalImage external_image(const vulkan::Target& target);
    static gpu::Context::Semaphores semaphores_of(const vulkan::Target& target);
    /// An image of the last frame, which is done, drawn once more where that takes it. Throws as read() does.
    graph::ImageId finished(std::string_view view);
    graph::ImageId output(std::string_view view) const;
    /// Whether an earlier frame in this slot, which is done, had too little room for its edges or its layers.
    bool outgrown(uint32_t slot) {
        const bool edges = edges_ && edges_->take(slot);
        return blended_.outgrown(slot) || edges;
    }
    void clear_counters(VkCommandBuffer commands) const;
    void tell_shadows(Stats& stats) const;

    const gpu::Context& context_;
    RenderOptions options_;
    Settings settings_;
    LightSums light_sums_;
    BlendedSurfaces blended_;
    PostFilter post_filter_;
    std::optional<PairCounters> pair_counters_;
    std::optional<passes::EdgeCounter> edges_; ///< with several samples a pixel
    std::optional<passes::Shadows> shadows_;   ///< of the graph that is built
    const World* world_ = nullptr;
    std::shared_ptr<resident::GpuScene> scene_; ///< of several renderers, after share_world()
    gpu::PerFrame<gpu::Buffer> update_staging_;
    std::unique_ptr<resident::LightSet> lights_;
    std::unique_ptr<resident::View> view_, light_view_;
    std::unique_ptr<graph::FrameGraph> graph_;
    Outputs outputs_;
    /// What the graph has a last pass for.
    struct TargetForm {
        VkFormat format = VK_FORMAT_UNDEFINED;
        std::string buffer;
        bool operator==(const TargetForm&) const = default;
    };
    std::optional<TargetForm> target_form_;
    OwnPasses own_passes_;
    uint64_t triangles_ = 0;             ///< of the world
    passes::ShadowCounts shadow_counts_; ///< of the last recording
    bool drawn_ = false;                 ///< the graph's images hold a frame
    PlacedCamera camera_;                ///< of that frame
    bool outgrown_ = false;              ///< a frame wanted more room than the graph has
    bool warm_ = false;                  ///< every pipeline of the graph has drawn once
    Stats stats_;                        ///< of a graph that is gone
    bool stats_stay_ = false;            ///< the last frame was drawn by read(): stats_ is what the one before it had
    double changes_ms_ = 0;              ///< of lights and world since the last frame
    FrameStats costs_;                   ///< of the last render()
    std::unique_ptr<FrameQueue> queue_;  ///< last: its end waits for the frames
};

} // namespace prelight
