#include "occlusion_settings.hpp"

namespace prelight {

std::vector<SettingInfo> occlusion_settings() {
    return {{"ssao",
             {"off", "half", "full"},
             "off",
             "ambient occlusion from depth and normals, searched at half or full resolution"},
            {"ssao-radius", {"0.01 … 100"}, "1", "ssao: metres within which surfaces occlude each other"}};
}

passes::OcclusionOptions occlusion_options(const Settings& settings) {
    return {.on = !settings.is("ssao", "off"),
            .half = settings.is("ssao", "half"),
            .radius = static_cast<float>(settings.number("ssao-radius"))};
}

} // namespace prelight
