#include "blended.hpp"
#include <algorithm>
#include <numeric>
#include <shared/bindings.h>
#include <tuple>

namespace prelight::passes {

SurfaceDraws::Desc blended_desc(const resident::View& view, ForwardInputs inputs, bool lists, bool more) {
    const char* const fragment = lists ? "forward_grid.frag" : "forward.frag";
    inputs.decals = {}; // those are of what is opaque
    SurfaceDraws::Desc desc = summed_desc(fragment, view, inputs, !more);
    desc.depth = gpu::DepthTest::behind_or_at;
    desc.keeps_alpha_mask = false;
    desc.blend = more ? gpu::Blend::add_by_alpha : gpu::Blend::by_alpha;
    desc.push_bytes = lists ? sizeof(shared::LightListConstants) : sizeof(shared::ForwardBatch);
    desc.draws = resident::DrawClass::blended;
    desc.softens = inputs.behind.has_value();
    desc.layer_decals = view.layer_decals() != nullptr;
    return desc;
}

std::shared_ptr<const shared::LightListConstants>
declare_blended(graph::FrameGraph& graph, graph::Pass& pass, const ForwardInputs& inputs, const LightLists* lists) {
    pass.blends()
        .depth_test(inputs.depth)
        .storage(INPUT_PAIR_COUNTERS, graph.buffer("pair counters", *inputs.pair_counters), inputs.count_pairs);
    declare_shadows(pass, inputs.shadows);
    if (inputs.behind)
        pass.sample(INPUT_DEPTH_BEHIND, *inputs.behind);
    if (!lists)
        return nullptr;
    declare_light_lists(pass, lists->rounds.at(0));
    return lists->rounds[0].constants;
}

uint64_t draw_lit(const graph::PassContext& pass, SurfaceDraws::Bound& bound, const SurfaceDraws& first,
                  const SurfaceDraws* more, uint32_t index, const shared::LightListConstants* lists,
                  const resident::LightReach& reach, uint32_t per_draw, SurfaceDraws::Faces faces) {
    if (lists)
        return first.draw(pass, bound, index, std::as_bytes(std::span(lists, 1)), faces);
    uint64_t drawn = 0;
    for (const shared::ForwardBatch& batch : batches_of(reach.of(index), per_draw))
        drawn += (drawn == 0 ? first : *more).draw(pass, bound, index, std::as_bytes(std::span(&batch, 1)), faces);
    return drawn;
}

namespace {

/// Visible ones, indices into Geometry::draws: where surfaces coincide the world's first one comes last.
void order_of_layer(const resident::View& view, std::vector<uint32_t>& out) {
    const std::vector<resident::Draw>& draws = view.scene().geometry().draws;
    out.clear();
    for (const resident::VisibleDraw& one : view.visible().blended())
        out.push_back(one.draw);
    std::sort(out.begin(), out.end(), [&](uint32_t a, uint32_t b) {
        return std::tuple(draws[a].object, draws[a].part) > std::tuple(draws[b].object, draws[b].part);
    });
}

} // namespace

void draw_blended(graph::Pass& pass, const resident::View& view, const SurfaceDraws::Desc& desc, BlendedOrder order,
                  uint64_t* counted, std::shared_ptr<const shared::LightListConstants> push) {
    auto draws = std::make_shared<std::optional<SurfaceDraws>>();
    pass.prepare([=, &view](const graph::PassInterface& interface) { draws->emplace(view, interface, desc); });
    pass.record([=, &view, ordered = std::vector<uint32_t>()](const graph::PassContext& context) mutable {
        if (order == BlendedOrder::layer) {
            order_of_layer(view, ordered);
        } else if (ordered.empty()) {
            ordered.resize(view.scene().geometry().draws.size());
            std::iota(ordered.begin(), ordered.end(), 0u);
        }
        const auto bytes = push ? std::as_bytes(std::span(push.get(), 1)) : std::span<const std::byte>();
        SurfaceDraws::Bound bound;
        uint64_t drawn = 0;
        (*draws)->bind_geometry(context);
        for (const uint32_t draw : ordered)
            drawn += (*draws)->draw(context, bound, draw, bytes);
        if (counted)
            *counted = drawn;
    });
}

namespace {

gpu::DepthTest depth_test_of(BlendedPart part) {
    return part == BlendedPart::layer    ? gpu::DepthTest::equal // exact: vertex_position() is invariant
           : part == BlendedPart::nearer ? gpu::DepthTest::behind
                                         : gpu::DepthTest::behind_or_at;
}

/// An object's draws, with one kind of light culling.
class BlendedDraws {
public:
    BlendedDraws(const resident::View& view, const graph::PassInterface& interface, const ForwardInputs& inputs,
                 uint32_t per_draw, std::shared_ptr<const shared::LightListConstants> lists, BlendedPart part)
        : view_(view), per_draw_(per_draw), lists_(std::move(lists)), part_(part),
          first_(view, interface, desc(inputs, false)) {
        if (!lists_)
            more_.emplace(view, interface, desc(inputs, true));
    }

    /// Returns the number of draws.
    uint64_t record(const graph::PassContext& pass) {
        SurfaceDraws::Bound bound;
        uint64_t drawn = 0;
        first_.bind_geometry(pass);
        for (const uint32_t index : ordered()) {
            using Faces = SurfaceDraws::Faces;
            if (part_ == BlendedPart::layer) {
                drawn += draw(pass, bound, index, Faces::all);
                continue;
            }
            if (view_.scene().geometry().draws[index].double_sided)
                drawn += draw(pass, bound, index, Faces::back);
            drawn += draw(pass, bound, index, Faces::front);
        }
        return drawn;
    }

private:
    SurfaceDraws::Desc desc(const ForwardInputs& inputs, bool more) const {
        SurfaceDraws::Desc out = blended_desc(view_, inputs, lists_ != nullptr, more);
        out.depth = depth_test_of(part_);
        return out;
    }

    const std::vector<uint32_t>& ordered() {
        if (part_ == BlendedPart::layer) {
            order_of_layer(view_, order_);
            return order_;
        }
        order_.clear();
        for (const resident::VisibleDraw& one : view_.visible().blended())
            order_.push_back(one.draw);
        return order_;
    }

    uint64_t draw(const graph::PassContext& pass, SurfaceDraws::Bound& bound, uint32_t index,
                  SurfaceDraws::Faces faces) const {
        return draw_lit(pass, bound, first_, more_ ? &*more_ : nullptr, index, lists_.get(), view_.reach(), per_draw_,
                        faces);
    }

    const resident::View& view_;
    uint32_t per_draw_;
    std::shared_ptr<const shared::LightListConstants> lists_;
    BlendedPart part_;
    SurfaceDraws first_;
    std::optional<SurfaceDraws> more_; ///< without lists
    std::vector<uint32_t> order_;
};

} // namespace

void blended_pass(graph::FrameGraph& graph, const resident::View& view, const ForwardInputs& inputs,
                  const BlendedLights& lights, BlendedPart part) {
    graph::Pass& pass = graph.pass(inputs.name);
    pass.colour(inputs.colour, graph::Load::keep);
    const auto lists = declare_blended(graph, pass, inputs, lights.lists);
    auto draws = std::make_shared<std::optional<BlendedDraws>>();
    pass.prepare([=, &view, per_draw = lights.per_draw](const graph::PassInterface& interface) {
        draws->emplace(view, interface, inputs, per_draw, lists, part);
    });
    pass.record([draws, counted = inputs.draws](const graph::PassContext& context) {
        const uint64_t drawn = (*draws)->record(context);
        if (counted)
            *counted = drawn;
    });
}

} // namespace prelight::passes
