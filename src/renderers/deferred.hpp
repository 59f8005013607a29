#pragma once
#include "device_renderer.hpp"

namespace prelight {

RendererInfo deferred_info();
std::unique_ptr<Renderer> make_deferred(Device& device, const RenderOptions& options);

} // namespace prelight
