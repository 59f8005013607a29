#include "layer_draws.hpp"
#include <shared/layer.h>

namespace prelight::passes {

void draw_layers(graph::Pass& pass, const resident::View& view, SurfaceDraws::Desc desc, const resident::View& slots,
                 uint64_t* drawn) {
    desc.keeps_alpha_mask = false; // they have none
    desc.push_bytes = sizeof(shared::LayerConstants);
    desc.draws = resident::DrawClass::blended;
    auto draws = std::make_shared<std::optional<SurfaceDraws>>();
    pass.prepare([=, &view](const graph::PassInterface& interface) { draws->emplace(view, interface, desc); });
    pass.record([=, &view, &slots](const graph::PassContext& context) {
        SurfaceDraws::Bound bound;
        uint64_t count = 0;
        (*draws)->bind_geometry(context);
        for (const resident::VisibleDraw& one : view.visible().blended()) {
            const shared::LayerConstants constants{slots.layers().of[one.draw]};
            if (constants.slot == 0)
                continue;
            const auto push = std::as_bytes(std::span(&constants, 1));
            using Faces = SurfaceDraws::Faces;
            if (view.scene().geometry().draws[one.draw].double_sided)
                count += (*draws)->draw(context, bound, one.draw, push, Faces::back);
            count += (*draws)->draw(context, bound, one.draw, push, Faces::front);
        }
        if (drawn)
            *drawn = count;
    });
}

} // namespace prelight::passes
