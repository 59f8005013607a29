#pragma once
#include "device_renderer.hpp"

namespace prelight {

RendererInfo inferred_info();
std::unique_ptr<Renderer> make_inferred(Device& device, const RenderOptions& options);

} // namespace prelight
