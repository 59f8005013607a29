#pragma once
#include <graph/frame_graph.hpp>
#include <map>
#include <memory>
#include <prelight/vulkan.hpp>
#include <resident/view.hpp>
#include <span>
#include <string_view>

namespace prelight {

/// The passes that a program adds to a renderer's frames (prelight/vulkan.hpp).
class OwnPasses {
public:
    /// Throws UsageError for one that no frame could have. Gives its number.
    uint64_t add(vulkan::Pass pass);
    /// Whether there was one of this number.
    bool remove(uint64_t number) { return passes_.erase(number) > 0; }
    bool any(vulkan::Stage stage) const;
    /// Whether one looks at surfaces by themselves, or at their light.
    bool any_before_materials() const { return any(vulkan::Stage::after_surfaces) || any(vulkan::Stage::after_light); }
    /// Whether one wants the scene-linear picture.
    bool any_linear() const { return any(vulkan::Stage::after_opaque) || any(vulkan::Stage::before_display); }

    /// What a stage has, by the names of vulkan::Stage.
    struct Offered {
        std::string_view name;
        graph::ImageId image;
    };
    /// A graph is about to be built.
    void begin() { missing_ = passes_; }
    /// Adds the stage's passes to the graph. `images`: what there is; "depth" may be tested too. Throws UsageError.
    void build(vulkan::Stage stage, graph::FrameGraph& graph, const resident::View& view,
               std::span<const Offered> images);
    /// The graph is there. Throws UsageError where it never came to the stage of one of the passes.
    void end() const;

private:
    using Passes = std::map<uint64_t, std::shared_ptr<const vulkan::Pass>>; ///< in the order in which they were added
    Passes passes_, missing_;
    uint64_t next_ = 1;
};

} // namespace prelight
