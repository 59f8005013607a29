#include "every_way.hpp"
#include <algorithm>
#include <cctype>

namespace prelight {

std::vector<Shot> every_way(const Shot& shot) {
    std::vector<Shot> shots;
    for (const RendererInfo& info : renderer_infos())
        for (const SettingInfo& setting : info.settings)
            // Inferred lighting finds lights as the light pre-pass does: tests/render/inferred_test.cpp.
            if (info.needs_device && info.name != "inferred" &&
                (setting.key == "light-culling" || setting.key == "lights" || setting.key == "order"))
                for (const std::string& value : setting.values) {
                    if (value == "auto")
                        continue; // one of the others
                    Shot& one = shots.emplace_back(shot);
                    one.renderer = info.name;
                    if (shot.shading == Shading::ggx)
                        one.settings["model"] = "nv";
                    one.settings[setting.key] = value;
                    if (value != "tiles")
                        continue;
                    one.settings["list-shading"] = "compute";
                    Shot other = one;
                    other.settings["list-shading"] = "fragment"; // what a GPU takes by itself
                    shots.push_back(other);
                }
    return shots;
}

Shot with_samples(Shot shot, uint32_t width) {
    shot.width = width;
    shot.height = width * 9 / 16;
    shot.samples = 4;
    return shot;
}

Shot in_way(Shot shot, const Way& way) {
    shot.renderer = way.renderer;
    shot.settings.insert(way.settings.begin(), way.settings.end());
    return shot;
}

std::string name_of(const Shot& shot) {
    std::string name = shot.renderer;
    for (const auto& [key, value] : shot.settings)
        name += " " + key + "=" + value;
    return name;
}

std::string way_name(const testing::TestParamInfo<Shot>& info) {
    std::string name = name_of(info.param);
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
}

uint64_t seed_of(const Shot& shot) {
    uint64_t seed = 11;
    for (const char c : name_of(shot))
        seed = seed * 31 + static_cast<unsigned char>(c);
    return seed;
}

} // namespace prelight
