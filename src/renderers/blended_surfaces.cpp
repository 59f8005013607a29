#include "blended_surfaces.hpp"
#include "settings/light_model_settings.hpp"
#include "settings/sample_settings.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <passes/k_buffer.hpp>
#include <passes/layer_peeler.hpp>
#include <passes/transmission.hpp>
#include <passes/weighted_blended.hpp>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>
#include <prelight/views.hpp>

namespace prelight {

BlendedSurfaces::BlendedSurfaces(Settings& settings, const gpu::Context& context, const RenderOptions& options) {
    resolve_transparency(settings, context, options);
    transparency_ = taken_ = transparency(settings);
    for (const std::string& view : options.views)
        if (const auto number = layer_of_view(view))
            asked_views_.insert(*number);
    reused_shadows_ = settings.has("shadow-memory") && settings.is("shadow-memory", "reuse");
    lists_possible_ = context.features().shuffle_lanes > 0;
    if (!wanted())
        return;
    if (draws_layers(transparency_)) {
        asked_layers_ = peeled_layers(settings);
        slots_ = k_buffer_layers(settings);
        asked_light_ = light_of_layers(settings);
    }
    if (draws_layers(transparency_) || transparency_ == Transparency::half_samples)
        counter_.emplace(context);
    per_draw_ = blended_lights(settings);
    if (settings.has("msaa-material"))
        sample_shading_ = material_shading(settings);
    model_ = blended_light_model(settings);
}

void BlendedSurfaces::adapt(Settings& settings, resident::ViewSettings& view, const resident::GpuScene& scene) const {
    if (!wanted())
        return;
    view.layer_decals = transparency_ != Transparency::half_samples || scene.transmits(); // else nobody reads them
    if (!reused_shadows_ || !view.shadows.on)
        return;
    view.shadows.reuse = !scene.shows_through();
    settings.resolve("shadow-memory", view.shadows.reuse ? "reuse" : "atlas",
                     "blended surfaces are lit by all lights at once");
}

void note_what_is_opaque(graph::FrameGraph& graph, const resident::GpuScene& scene, const std::string& why) {
    const std::vector<Material>& materials = scene.world().scene->materials;
    const auto any = [&](auto is) {
        return std::ranges::any_of(scene.geometry().draws,
                                   [&](const resident::Draw& draw) { return is(materials[draw.material]); });
    };
    if (!scene.blends() && any([](const Material& material) { return material.alpha_mode == AlphaMode::blend; }))
        graph.note(why + ": surfaces with alphaMode BLEND are drawn opaque");
    if (any(transmits))
        graph.note(why + ": nothing is seen through materials with KHR_materials_transmission");
}

void note_missing_decals(graph::FrameGraph& graph, const resident::GpuScene& scene) {
    if (scene.blends() && !scene.decals().empty() && !resident::LayerDecals::fits(scene.context()))
        graph.note("decals do not lie on blended surfaces: the device has too few samplers");
}

void note_left_out_decals(Stats& stats, const resident::LayerDecals* decals) {
    if (decals && decals->left_out() > 0)
        stats.notes.push_back(fmt::format("{} decals on blended surfaces are left out: {} lie on one object at most",
                                          decals->left_out(), LAYER_DECALS_MOST));
}

void BlendedSurfaces::choose(Settings& settings, graph::FrameGraph& graph, resident::View& view) {
    draws_.clear();
    layers_ = 0;
    counted_.reset();
    shown_layers_.clear();
    counting_ = false;
    by_lists_ = false;
    in_half_samples_ = false;
    decals_ = nullptr;
    taken_ = transparency_;
    const resident::GpuScene& scene = view.scene();
    if (settings.has("transparency") && !wanted())
        note_what_is_opaque(graph, scene, "transparency=opaque");
    if (!scene.shows_through() || !wanted())
        return;
    if (reused_shadows_ && view.shadows())
        graph.note("shadow-memory=reuse: blended surfaces are lit by all lights at once, atlas is taken");
    if (transparency_ == Transparency::half_samples && scene.transmits()) {
        taken_ = lists_possible_ ? Transparency::lists : Transparency::sorted;
        const std::string why = "light that comes through materials shows the picture behind them",
                          word = transparency_word(taken_);
        graph.note(fmt::format("transparency=half-samples: {}, {} is taken", why, word));
        settings.resolve("transparency", word, why);
    } else if (transparency_ == Transparency::half_samples) {
        in_half_samples_ = true;
        if (scene.softens())
            graph.note("transparency=half-samples: soft surfaces end sharply before what is opaque");
        settings.resolve("transparency", transparency_word(taken_), {});
    }
    decals_ = view.layer_decals();
    note_missing_decals(graph, scene);
    choose_lists(settings, graph, view);
    view.find_blended_lights(!by_lists_ && !in_half_samples_);
}

void BlendedSurfaces::choose_lists(Settings& settings, graph::FrameGraph& graph, const resident::View& view) {
    if (!takes_lists(taken_) || !lists_possible_)
        return;
    const uint32_t rounds = passes::light_rounds(view, passes::LightWalk::fragment).count;
    by_lists_ = rounds == 1;
    const std::string word = transparency_word(taken_);
    const std::string why =
        fmt::format("{} lights take {} rounds of lists, which cannot be blended", view.lights().capacity(), rounds);
    const bool sorted = !by_lists_ && needs_lists(taken_);
    if (!by_lists_)
        graph.note(fmt::format("transparency={}: {}, {}", word, why,
                               sorted ? "sorted is taken" : "lights are found object by object"));
    if (sorted || taken_ == transparency_)
        settings.resolve("transparency", sorted ? "sorted" : word, why);
}

void BlendedSurfaces::count_layers(graph::FrameGraph& graph, const resident::View& view, graph::ImageId depth) {
    counted_ = passes::layer_count_pass(graph, view, "blended layers", depth);
    layers_ = 1;
    counter_->count(graph, view, "blended layers sum", *counted_, layers_);
}

std::optional<graph::ImageId> BlendedSurfaces::add(graph::FrameGraph& graph, const resident::View& view,
                                                   passes::ForwardInputs inputs, const passes::LightLists* lists,
                                                   Settings& settings, const LayerLight& layer_light,
                                                   bool wants_layers) {
    if (!view.scene().shows_through() || !wanted() || in_half_samples_)
        return counted_;
    inputs.model = model_;
    inputs.sample_shading = sample_shading_;
    if (view.scene().softens())
        inputs.behind = inputs.depth;
    std::optional<passes::LightLists> own;
    if (by_lists_ && !lists)
        lists = &own.emplace(passes::grid_light_lists(graph, view, "blended", passes::GridOver::layers));
    const passes::BlendedLights lights{.lists = by_lists_ ? lists : nullptr, .per_draw = per_draw_};
    if (view.scene().transmits()) {
        inputs.name = "transmission";
        inputs.depth = passes::transmission_passes(graph, view, counted(inputs), lights);
    }
    if (!view.scene().blends())
        return {};
    show_layers(graph, view, inputs, lights);
    inputs.name = "blended";
    const bool peeled = taken_ == Transparency::peeled, buffered = taken_ == Transparency::k_buffer && by_lists_;
    std::optional<graph::ImageId> layers;
    if (peeled || buffered || wants_layers)
        layers = passes::layer_count_pass(graph, view, "blended layers", inputs.depth);
    if (by_lists_ && taken_ == Transparency::weighted)
        passes::weighted_blended_pass(graph, view, counted(inputs), *lists);
    else if (peeled)
        add_peeled(graph, view, inputs, {lights, lit_layers(graph, view, settings, layer_light)}, *layers);
    else if (buffered)
        add_buffered(graph, view, inputs, {lights, lit_layers(graph, view, settings, layer_light)}, *layers);
    else
        passes::blended_pass(graph, view, counted(inputs), lights);
    return layers;
}

void BlendedSurfaces::show_layers(graph::FrameGraph& graph, const resident::View& view, passes::ForwardInputs inputs,
                                  const passes::BlendedLights& lights) {
    if (asked_views_.empty())
        return;
    passes::LayerPeeler peeler(graph, view, inputs.depth, passes::LayerPeeler::First::nearest);
    inputs.count_pairs = false; // of the picture
    const graph::ImageDesc desc = graph.desc(inputs.colour);
    for (uint32_t number = 1; number <= *asked_views_.rbegin(); ++number) {
        inputs.name = fmt::format("view-layer {}", number);
        inputs.depth = peeler.next(graph, view, inputs.name + " peel");
        if (!asked_views_.contains(number))
            continue;
        inputs.colour = shown_layers_[number] = graph.image(inputs.name, desc);
        graph.pass(inputs.name + " none").colour(inputs.colour, graph::Load::clear).record([](const auto&) {});
        passes::blended_pass(graph, view, inputs, lights, passes::BlendedPart::layer);
    }
}

void BlendedSurfaces::add_peeled(graph::FrameGraph& graph, const resident::View& view,
                                 const passes::ForwardInputs& inputs, LayerLights lights, graph::ImageId layers) {
    if (const uint32_t most = counter_->most(); most > 0)
        known_layers_ = most;
    counting_ = !asked_layers_ && !known_layers_;
    layers_ = counting_ ? 0 : asked_layers_.value_or(std::max(known_layers_.value_or(0), 1u));
    counter_->count(graph, view, "blended layers sum", layers, layers_);
    if (counting_)
        return;
    passes::LayerPeeler peeler(graph, view, inputs.depth);
    for (uint32_t layer = 1; layer <= layers_; ++layer)
        add_layer(graph, view, inputs, lights, peeler.next(graph, view, fmt::format("blended peel {}", layer)), layer);
    passes::ForwardInputs nearer = counted(inputs);
    nearer.depth = peeler.last();
    passes::blended_pass(graph, view, nearer, lights.forward, passes::BlendedPart::nearer);
}

void BlendedSurfaces::add_buffered(graph::FrameGraph& graph, const resident::View& view,
                                   const passes::ForwardInputs& inputs, LayerLights lights, graph::ImageId layers) {
    passes::KBuffer slots(graph, view, "blended slots", inputs.depth, slots_);
    layers_ = slots.count();
    counter_->count(graph, view, "blended layers sum", layers, layers_);
    passes::weighted_blended_pass(graph, view, counted(inputs), *lights.forward.lists, &slots);
    for (uint32_t layer = layers_; layer > 0; --layer)
        add_layer(graph, view, inputs, lights,
                  slots.depth(graph, view, fmt::format("blended slot {}", layer), layer - 1), layer);
}

void BlendedSurfaces::add_layer(graph::FrameGraph& graph, const resident::View& view,
                                const passes::ForwardInputs& inputs, LayerLights& lights, graph::ImageId depth,
                                uint32_t number) {
    passes::ForwardInputs one = counted(inputs);
    one.name = fmt::format("blended layer {}", number);
    one.depth = depth;
    if (lights.lit)
        lights.lit->add(graph, view, one.name, depth, one.colour, one.draws);
    else
        passes::blended_pass(graph, view, one, lights.forward, passes::BlendedPart::layer);
}

std::optional<passes::LitLayers> BlendedSurfaces::lit_layers(graph::FrameGraph& graph, const resident::View& view,
                                                             Settings& settings, const LayerLight& layer_light) const {
    // Of fewer the lists of each layer cost more than the light itself: docs/transparency.md.
    constexpr size_t many = 64;
    if (asked_light_ == LightOfLayers::lists)
        return {};
    const bool asked = asked_light_ == LightOfLayers::light_buffer;
    if (!layer_light.inputs || view.scene().softens() || view.layer_decals()) {
        const std::string why = !layer_light.inputs   ? layer_light.obstacle
                                : view.layer_decals() ? "decals lie on blended surfaces"
                                                      : "soft surfaces look at the depth behind them";
        resolve_light_of_layers(settings, LightOfLayers::lists, why);
        if (asked)
            graph.note(fmt::format("layer-light=light-buffer: {}, lists are taken", why));
        return {};
    }
    const size_t lights = view.lights().placed().size();
    const bool buffer = asked || lights >= many;
    resolve_light_of_layers(settings, buffer ? LightOfLayers::light_buffer : LightOfLayers::lists,
                            fmt::format("{} lights", lights));
    if (!buffer)
        return {};
    return passes::LitLayers(graph, view, *layer_light.inputs);
}

passes::ForwardInputs BlendedSurfaces::counted(passes::ForwardInputs inputs) {
    inputs.draws = count_draws();
    return inputs;
}

void BlendedSurfaces::take_count() { known_layers_ = counter_->most(); }

void BlendedSurfaces::forget() {
    known_layers_.reset();
    if (counter_)
        counter_->forget();
}

bool BlendedSurfaces::outgrown(uint32_t slot) const {
    return transparency_ == Transparency::peeled && layers_ > 0 && !asked_layers_ && counter_->most(slot) > layers_;
}

void BlendedSurfaces::tell(Stats& stats) const {
    const uint64_t draws = std::accumulate(draws_.begin(), draws_.end(), uint64_t(0));
    stats.draws += draws;
    if (taken_ == Transparency::weighted && by_lists_ && draws > 0)
        stats.notes.push_back(fmt::format(
            "transparency=weighted: {} draws of blended surfaces are composed without order, approximately", draws));
    note_left_out_decals(stats, decals_);
    if (layers_ == 0)
        return;
    const passes::LayerCounter::Sums sums = counter_->last();
    stats.layers = {.most = sums.most,
                    .mean = sums.mean,
                    .exact = layers_,
                    .approximate = static_cast<uint64_t>(std::ceil(sums.more))};
    if (stats.layers->approximate == 0)
        return;
    if (in_half_samples_) {
        stats.notes.push_back(fmt::format(
            "transparency=half-samples: {} fragments behind the nearest layer of their pixels are left out; {} layers "
            "are the most",
            stats.layers->approximate, sums.most));
        return;
    }
    const bool peeled = taken_ == Transparency::peeled;
    stats.notes.push_back(fmt::format(
        "transparency={}: {} fragments {} the {} {} layers of their pixels are composed {}, "
        "approximately; {} layers are the most",
        transparency_word(taken_), stats.layers->approximate, peeled ? "nearer than" : "behind", layers_,
        peeled ? "farthest" : "nearest", peeled ? "object by object" : "by their weighted mean", sums.most));
}

} // namespace prelight
