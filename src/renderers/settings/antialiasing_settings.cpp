#include "antialiasing_settings.hpp"

namespace prelight {
namespace {

constexpr Choice<Antialiasing> antialiasing_words[] = {
    {"none", Antialiasing::none}, {"edge-blur", Antialiasing::edge_blur}, {"smaa", Antialiasing::smaa}};
constexpr ChoiceSetting<Antialiasing> antialiasing_choice{
    "antialiasing", antialiasing_words, "none",
    "of the tone-mapped picture, not of \"linear\" (EXR) and other views. edge-blur: a blur where depth and normals "
    "(depth alone "
    "in forward renderers) have an edge; smaa: along the lines that edges of luma make"};

} // namespace

SettingInfo antialiasing_setting() { return antialiasing_choice.info(); }

Antialiasing antialiasing(const Settings& settings) {
    return settings.has(antialiasing_choice.key) ? settings.value(antialiasing_choice) : Antialiasing::none;
}

} // namespace prelight
