#pragma once
#include "settings.hpp"
#include <gpu/context.hpp>
#include <gpu/sample_shading.hpp>
#include <passes/sample_surfaces.hpp>

namespace prelight {

/// `msaa-material`, of every renderer that shades surfaces as it draws them.
SettingInfo msaa_material_setting();
gpu::SampleShading material_shading(const Settings& settings);

/// `msaa-light`, of renderers that light what they drew before. `once`: a pixel's materials may share one light.
SettingInfo msaa_light_setting(bool once);
passes::SampleLight sample_light(const Settings& settings);
/// `msaa-shadows`, of the same.
SettingInfo msaa_shadows_setting();
bool shadows_per_pixel(const Settings& settings);

/// What several samples a pixel cannot go with gives way to what they can: depth in a colour target, roughness in
/// stencil and shadow maps drawn light by light.
void resolve_sample_settings(Settings& settings, const gpu::Context& context, uint32_t samples);

} // namespace prelight
