#pragma once
#include "settings.hpp"
#include <gpu/context.hpp>
#include <gpu/texture.hpp>

namespace prelight {

/// `texture-filter`, of every renderer on a device.
SettingInfo texture_filter_setting();
/// Replaces "auto" by what is best on the device, and anisotropy where it has none, with a note.
void resolve_texture_filter(Settings& settings, const gpu::Context& context);
/// What the resolved setting says.
gpu::TextureFilter texture_filter(const Settings& settings);

} // namespace prelight
