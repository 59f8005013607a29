#pragma once
#include "settings.hpp"
#include <gpu/context.hpp>
#include <resident/visible_draws.hpp>

namespace prelight {

/// The settings of every architecture that say how geometry is drawn.
/// `twice`: of one that draws all geometry twice, and may leave out in the second pass what the first one hid.
std::vector<SettingInfo> draw_settings(bool twice);
/// Of every architecture that lights surfaces.
SettingInfo specular_antialiasing_setting();
/// Replaces "auto" by what is best on the device, and what it lacks by what it has, with a note.
void resolve_draw_settings(Settings& settings, const gpu::Context& context);
/// What resolved settings say; defaults of DrawOptions where a renderer has none of them.
resident::DrawOptions draw_options(const Settings& settings);

} // namespace prelight
