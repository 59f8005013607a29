#include "blended.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

SurfaceDraws::Desc blended_desc(const resident::View& view, ForwardInputs inputs, bool lists, bool more) {
    const char* const fragment = lists ? "forward_grid.frag" : "forward.frag";
    // Weighted Fresnel needs the sums of all lights, which materials with a shader of their own get.
    const bool sums = inputs.model.fresnel == FresnelModel::weighted && inputs.model.shading == Shading::ggx;
    if (sums)
        inputs.model.fresnel = FresnelModel::full;
    inputs.decals = {}; // they lie on what is opaque
    SurfaceDraws::Desc desc = forward_desc(fragment, view, inputs, !more);
    desc.own_fragment = desc.fragment;
    if (sums)
        desc.fragment = {fragment, desc.fragment.variants | gpu::Variant::own_material, "metallic_roughness"};
    desc.depth = gpu::DepthTest::behind_or_at;
    desc.keeps_alpha_mask = false;
    desc.blend = more ? gpu::Blend::add_by_alpha : gpu::Blend::by_alpha;
    desc.push_bytes = lists ? sizeof(shared::LightListConstants) : sizeof(shared::ForwardBatch);
    desc.blended = true;
    return desc;
}

std::shared_ptr<const shared::LightListConstants>
declare_blended(graph::FrameGraph& graph, graph::Pass& pass, const ForwardInputs& inputs, const LightLists* lists) {
    pass.blends()
        .depth_test(inputs.depth)
        .storage(INPUT_PAIR_COUNTERS, graph.buffer("pair counters", *inputs.pair_counters), inputs.count_pairs);
    declare_shadows(pass, inputs.shadows);
    if (!lists)
        return nullptr;
    declare_light_lists(pass, lists->rounds.at(0));
    return lists->rounds[0].constants;
}

namespace {

/// An object's draws, in one way to find lights.
class BlendedDraws {
public:
    BlendedDraws(const resident::View& view, const graph::PassInterface& interface, const ForwardInputs& inputs,
                 uint32_t per_draw, std::shared_ptr<const shared::LightListConstants> lists)
        : view_(view), per_draw_(per_draw), lists_(std::move(lists)),
          first_(view, interface, blended_desc(view, inputs, lists_ != nullptr, false)) {
        if (!lists_)
            more_.emplace(view, interface, blended_desc(view, inputs, false, true));
    }

    /// Returns the number of draws.
    uint64_t record(const graph::PassContext& pass) const {
        SurfaceDraws::Bound bound;
        uint64_t drawn = 0;
        first_.bind_geometry(pass);
        for (const resident::VisibleDraw& one : view_.visible().blended()) {
            using Faces = SurfaceDraws::Faces;
            if (view_.scene().geometry().draws[one.draw].double_sided)
                drawn += draw(pass, bound, one.draw, Faces::back);
            drawn += draw(pass, bound, one.draw, Faces::front);
        }
        return drawn;
    }

private:
    uint64_t draw(const graph::PassContext& pass, SurfaceDraws::Bound& bound, uint32_t index,
                  SurfaceDraws::Faces faces) const {
        if (lists_)
            return first_.draw(pass, bound, index, std::as_bytes(std::span(lists_.get(), 1)), faces);
        uint64_t drawn = 0;
        for (const shared::ForwardBatch& batch : batches_of(view_.reach().of(index), per_draw_))
            drawn +=
                (drawn == 0 ? first_ : *more_).draw(pass, bound, index, std::as_bytes(std::span(&batch, 1)), faces);
        return drawn;
    }

    const resident::View& view_;
    uint32_t per_draw_;
    std::shared_ptr<const shared::LightListConstants> lists_;
    SurfaceDraws first_;
    std::optional<SurfaceDraws> more_; ///< without lists
};

} // namespace

void blended_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs,
                  const BlendedLights& lights) {
    graph::Pass& pass = graph.pass(inputs.name);
    pass.colour(inputs.colour, graph::Load::keep);
    const auto lists = declare_blended(graph, pass, inputs, lights.lists);
    auto draws = std::make_shared<std::optional<BlendedDraws>>();
    pass.prepare([=, &view, per_draw = lights.per_draw](const graph::PassInterface& interface) {
        draws->emplace(view, interface, inputs, per_draw, lists);
    });
    pass.record([draws, counted = inputs.draws](const graph::PassContext& context) {
        const uint64_t drawn = (*draws)->record(context);
        if (counted)
            *counted = drawn;
    });
}

} // namespace prelight::passes
