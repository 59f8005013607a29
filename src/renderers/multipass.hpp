#pragma once
#include "device_renderer.hpp"

namespace prelight {

RendererInfo multipass_info();
std::unique_ptr<Renderer> make_multipass(Device& device, const RenderOptions& options);

} // namespace prelight
