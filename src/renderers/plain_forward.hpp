#pragma once
#include <memory>
#include <prelight/renderer.hpp>

namespace prelight {

/// The unit F of `bench --limit`, not an architecture: renderer_infos() does not list it.
std::unique_ptr<Renderer> make_plain_forward(Device& device, const RenderOptions& options);

} // namespace prelight
