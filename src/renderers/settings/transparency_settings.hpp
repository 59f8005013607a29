#pragma once
#include "settings.hpp"
#include <gpu/context.hpp>

namespace prelight {

/// How surfaces with alphaMode BLEND are drawn.
enum class Transparency {
    lists,        ///< back to front, each fragment with the lights of its place in the world
    sorted,       ///< back to front, each object with its own lights, a few a draw
    peeled,       ///< layer after layer of each pixel, the farthest first; lights as with `lists`
    k_buffer,     ///< the nearest layers of each pixel in their order, over the mean of the rest; lights likewise
    weighted,     ///< in any order, by the mean of all layers; lights as with `lists`
    half_samples, ///< the nearest layer as if it were opaque, in two of four samples
    opaque        ///< as if they were opaque
};

/// How a layer's light is found.
enum class LightOfLayers { automatic, lists, light_buffer };

/// The settings of every architecture on a device that say how blended surfaces are drawn. `lit_later`: lights see what
/// was drawn before, so that Transparency::half_samples has a point.
std::vector<SettingInfo> transparency_settings(bool lit_later);
/// What the device cannot gives way to what it can, with a note. Throws UsageError where `samples` a pixel are not what
/// Transparency::half_samples needs.
void resolve_transparency(Settings& settings, const gpu::Context& context, const RenderOptions& options);
/// `opaque` where a renderer has no such setting.
Transparency transparency(const Settings& settings);
/// Lights come from lists of a grid over the world.
inline bool takes_lists(Transparency one) {
    return one != Transparency::sorted && one != Transparency::half_samples && one != Transparency::opaque;
}
/// Without lists `sorted` takes its place; others are what they are with lights of the object's.
inline bool needs_lists(Transparency one) { return takes_lists(one) && one != Transparency::peeled; }
/// Layer after layer of each pixel.
inline bool draws_layers(Transparency one) { return one == Transparency::peeled || one == Transparency::k_buffer; }
/// As --set has it.
std::string transparency_word(Transparency one);
/// Of Transparency::sorted.
uint32_t blended_lights(const Settings& settings);
/// Of Transparency::peeled; none: as many as there are.
std::optional<uint32_t> peeled_layers(const Settings& settings);
/// Of Transparency::k_buffer.
uint32_t k_buffer_layers(const Settings& settings);
/// `layer-light`, of an architecture with a light buffer.
SettingInfo light_of_layers_setting();
/// What it says; `lists` where a renderer has no such setting.
LightOfLayers light_of_layers(const Settings& settings);
/// What it came to, `light_buffer` or `lists`.
void resolve_light_of_layers(Settings& settings, LightOfLayers taken, const std::string& why);

} // namespace prelight
