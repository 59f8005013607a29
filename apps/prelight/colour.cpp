#include "colour.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <prelight/glm_defaults.hpp>
#include <utility>

namespace prelight::app {
namespace {

constexpr std::array<std::pair<std::string_view, uint32_t>, 19> named_colours{{{"white", 0xffffff},
                                                                               {"silver", 0xc0c0c0},
                                                                               {"grey", 0x808080},
                                                                               {"gray", 0x808080},
                                                                               {"red", 0xff0000},
                                                                               {"maroon", 0x800000},
                                                                               {"yellow", 0xffff00},
                                                                               {"olive", 0x808000},
                                                                               {"lime", 0x00ff00},
                                                                               {"green", 0x008000},
                                                                               {"aqua", 0x00ffff},
                                                                               {"cyan", 0x00ffff},
                                                                               {"teal", 0x008080},
                                                                               {"blue", 0x0000ff},
                                                                               {"navy", 0x000080},
                                                                               {"fuchsia", 0xff00ff},
                                                                               {"magenta", 0xff00ff},
                                                                               {"purple", 0x800080},
                                                                               {"orange", 0xffa500}}};

glm::vec3 of_bytes(uint32_t rgb) {
    return glm::vec3(float(rgb >> 16 & 255), float(rgb >> 8 & 255), float(rgb & 255)) / 255.0f;
}

} // namespace

std::optional<glm::vec3> find_colour(const std::string& text) {
    const auto named = std::ranges::find(named_colours, std::string_view(text), [](const auto& c) { return c.first; });
    if (named != named_colours.end())
        return of_bytes(named->second);
    if (text.empty() || text[0] != '#' || (text.size() != 4 && text.size() != 7))
        return {};
    std::string digits = text.substr(1);
    if (digits.size() == 3)
        digits = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
    uint32_t rgb = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), rgb, 16);
    if (error != std::errc() || end != digits.data() + digits.size())
        return {};
    return of_bytes(rgb);
}

std::vector<std::string> colour_names() {
    std::vector<std::string> names;
    for (const auto& [name, rgb] : named_colours)
        names.emplace_back(name);
    return names;
}

} // namespace prelight::app
