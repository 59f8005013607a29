#pragma once
#include <algorithm>
#include <cstdlib>
#include <prelight/renderer.hpp>
#include <string>
#include <string_view>

namespace prelight {

/// Whether a setting may have the value: one of its words; or, where its only word is a range "LOW … HIGH", a number in it.
inline bool allows(const SettingInfo& setting, const std::string& value) {
    constexpr std::string_view dots = " … ";
    const std::string first = setting.values.size() == 1 ? setting.values[0] : "";
    const size_t between = first.find(dots);
    if (between == std::string::npos)
        return std::find(setting.values.begin(), setting.values.end(), value) != setting.values.end();
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end), low = std::strtod(first.c_str(), nullptr);
    return !value.empty() && *end == 0 && number >= low && number <= std::strtod(first.c_str() + between + dots.size(), nullptr);
}

} // namespace prelight
