#include "light_sums.hpp"
#include <fmt/format.h>

namespace prelight {

SettingInfo light_sums_setting() {
    return {"light-sums",
            {"auto", "target", "float32"},
            "auto",
            "what blended light is added up in: the target's own format, or RGBA32F; auto: RGBA32F where more than 16 "
            "lights meet"};
}

LightSums::LightSums(const Settings& settings) : asked_(settings.has("light-sums") ? settings.get("light-sums") : "") {}

void LightSums::choose(Settings& settings, graph::FrameGraph& graph, const gpu::Context& context, uint32_t adds) {
    if (asked_.empty())
        return;
    blends_ = context.supports(VK_FORMAT_R32G32B32A32_SFLOAT, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT) &&
              context.supports(VK_FORMAT_R32_SFLOAT, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT);
    const bool wanted = asked_ == "float32" || (asked_ == "auto" && adds > most_in_half);
    wide_ = wanted && blends_;
    if (wanted && !blends_)
        graph.note(fmt::format(
            "light-sums: RGBA32F does not blend on {}, up to {} lights are added up in half floats, which lose "
            "some of the light (light-culling=tiles and lights=grid do not)",
            context.name(), adds));
    settings.resolve("light-sums", wide_ ? "float32" : "target",
                     wanted == wide_ ? fmt::format("up to {} lights are added up", adds) : "RGBA32F does not blend");
}

bool LightSums::holds(uint32_t adds) const {
    if (asked_ != "auto" || !blends_)
        return true;
    return wide_ == (adds > most_in_half);
}

} // namespace prelight
