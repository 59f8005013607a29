#pragma once
#include "settings.hpp"
#include <gpu/context.hpp>

namespace prelight {

/// How surfaces with alphaMode BLEND are drawn.
enum class Transparency {
    lists,    ///< back to front, each fragment with the lights of its place in the world
    sorted,   ///< back to front, each object with its own lights, a few a draw
    weighted, ///< in any order, by the mean of all layers; lights as with `lists`
    opaque    ///< as if they were opaque
};

/// The settings of every architecture on a device that say how blended surfaces are drawn.
std::vector<SettingInfo> transparency_settings();
/// What the device cannot gives way to what it can, with a note.
void resolve_transparency(Settings& settings, const gpu::Context& context);
/// `opaque` where a renderer has no such setting.
Transparency transparency(const Settings& settings);
/// Lights come from lists of a grid over the world.
inline bool takes_lists(Transparency one) { return one == Transparency::lists || one == Transparency::weighted; }
/// As --set has it.
std::string transparency_word(Transparency one);
/// Of Transparency::sorted.
uint32_t blended_lights(const Settings& settings);

} // namespace prelight
