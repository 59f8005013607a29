#include "transparency_settings.hpp"

namespace prelight {
namespace {

constexpr Choice<Transparency> transparency_words[] = {{"lists", Transparency::lists},
                                                       {"sorted", Transparency::sorted},
                                                       {"weighted", Transparency::weighted},
                                                       {"opaque", Transparency::opaque}};
constexpr ChoiceSetting<Transparency> transparency_setting{
    "transparency", transparency_words, "lists",
    "BLEND surfaces, back to front: lights by lists of their place, or a few of the object's a draw; weighted: in any "
    "order, approximate; or drawn opaque"};

} // namespace

std::vector<SettingInfo> transparency_settings() {
    return {transparency_setting.info(),
            {"blended-lights",
             {"1", "2", "3", "4", "5", "6", "7", "8"},
             "8",
             "transparency=sorted: lights that one draw of a blended object takes"}};
}

void resolve_transparency(Settings& settings, const gpu::Context& context) {
    if (takes_lists(transparency(settings)) && context.features().shuffle_lanes == 0)
        settings.fall_back(transparency_setting.key, transparency_setting.word(Transparency::sorted),
                           context.name() +
                               " cannot build light lists, which need shuffles within subgroups of at most 64");
}

Transparency transparency(const Settings& settings) {
    return settings.has(transparency_setting.key) ? settings.value(transparency_setting) : Transparency::opaque;
}

std::string transparency_word(Transparency one) { return transparency_setting.word(one); }

uint32_t blended_lights(const Settings& settings) { return static_cast<uint32_t>(settings.number("blended-lights")); }

} // namespace prelight
