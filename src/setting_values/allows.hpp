#pragma once
#include <algorithm>
#include <cstdlib>
#include <prelight/renderer.hpp>
#include <string>
#include <string_view>

namespace prelight {

/// Whether `value` is a number in "LOW … HIGH"; false where `range` is a word.
inline bool in_range(const std::string& range, const std::string& value) {
    constexpr std::string_view dots = " … ";
    const size_t between = range.find(dots);
    if (between == std::string::npos || value.empty())
        return false;
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end), low = std::strtod(range.c_str(), nullptr);
    return *end == 0 && number >= low && number <= std::strtod(range.c_str() + between + dots.size(), nullptr);
}

/// Whether a setting may have the value: one of its words, or a number in one of its ranges "LOW … HIGH".
inline bool allows(const SettingInfo& setting, const std::string& value) {
    return std::any_of(setting.values.begin(), setting.values.end(), [&](const std::string& one) {
        return in_range(one, value) || (one == value && one.find(" … ") == std::string::npos);
    });
}

} // namespace prelight
