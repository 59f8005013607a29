#include "light_prepass.hpp"
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <reference/reference_renderer.hpp>

namespace prelight {

std::vector<RendererInfo> renderer_infos() { return {light_prepass_info(), reference_info()}; }

std::unique_ptr<Renderer> create_renderer(std::string_view name, Device* device,
                                          const RenderOptions& options) {
    if (name == "reference")
        return make_reference_renderer(options);
    if (name != "light-prepass")
        throw UsageError(fmt::format("--renderer {}: no such renderer (prelight renderers lists them)", name));
    if (!device)
        throw Error(fmt::format("renderer {}: needs a Vulkan device", name));
    return make_light_prepass(*device, options);
}

} // namespace prelight
