#pragma once
#include <graph/frame_graph.hpp>
#include <gpu/pipeline.hpp>
#include <map>
#include <resident/frame.hpp>

namespace prelight::passes {

/// Draws every object of a frame with one fragment shader: one pipeline for each set of material
/// features that the world uses. What the depth-normal pass and the material pass have in common.
class SurfaceDraws {
public:
    struct Desc {
        std::string name;
        std::string fragment;
        gpu::Constants constants;
        gpu::DepthTest depth = gpu::DepthTest::write_nearer;
        bool keeps_alpha_mask = true; ///< false: the mask is not asked again, the depth test decides
    };
    SurfaceDraws(const resident::Frame& frame, const graph::PassInterface& interface, const Desc& desc);
    void record(const graph::PassContext& pass) const;

private:
    uint32_t key(const resident::Draw& draw) const;
    const resident::Frame& frame_;
    uint32_t ignored_features_ = 0;
    std::map<uint32_t, gpu::GraphicsPipeline> pipelines_; ///< by FEATURE_… bits
};

} // namespace prelight::passes
