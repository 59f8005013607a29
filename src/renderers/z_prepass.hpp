#pragma once
#include "device_renderer.hpp"

namespace prelight {

RendererInfo z_prepass_info();
std::unique_ptr<Renderer> make_z_prepass(Device& device, const RenderOptions& options);

} // namespace prelight
