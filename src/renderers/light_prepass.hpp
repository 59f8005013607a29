#pragma once
#include "device_renderer.hpp"

namespace prelight {

RendererInfo light_prepass_info();
std::unique_ptr<Renderer> make_light_prepass(Device& device, const RenderOptions& options);

} // namespace prelight
