#include "deferred.hpp"
#include "inferred.hpp"
#include "light_prepass.hpp"
#include "multipass.hpp"
#include "plain_forward.hpp"
#include "z_prepass.hpp"
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <reference/reference_renderer.hpp>
#include <setting_values/needs.hpp>

namespace prelight {

std::vector<RendererInfo> renderer_infos() {
    std::vector<RendererInfo> all{light_prepass_info(), multipass_info(), z_prepass_info(),
                                  deferred_info(),      inferred_info(),  reference_info()};
    for (RendererInfo& info : all)
        for (SettingInfo& setting : info.settings)
            setting.needs = needs_of(setting.key, info.settings);
    return all;
}

std::unique_ptr<Renderer> create_renderer(std::string_view name, Device* device, const RenderOptions& options) {
    if (name == "reference")
        return make_reference_renderer(options);
    const auto make = name == "light-prepass"   ? make_light_prepass
                      : name == "multipass"     ? make_multipass
                      : name == "z-prepass"     ? make_z_prepass
                      : name == "deferred"      ? make_deferred
                      : name == "inferred"      ? make_inferred
                      : name == "plain-forward" ? make_plain_forward // of bench: in no list
                                                : nullptr;
    if (!make)
        throw UsageError(fmt::format("--renderer {}: no such renderer (prelight renderers lists them)", name));
    if (!device)
        throw Error(fmt::format("renderer {}: needs a Vulkan device", name));
    return make(*device, options);
}

} // namespace prelight
