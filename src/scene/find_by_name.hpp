#pragma once
#include <charconv>
#include <cstdint>
#include <fmt/format.h>
#include <optional>
#include <string>

namespace prelight {

/// The first of `count` things with that name (empty names are no names), or else the one with that
/// index in decimal.
template <class NameOf>
std::optional<size_t> find_by_name(const std::string& name_or_index, size_t count, NameOf name_of) {
    for (size_t i = 0; i < count; ++i)
        if (!name_of(i).empty() && name_of(i) == name_or_index)
            return i;
    size_t index = 0;
    const char* end = name_or_index.data() + name_or_index.size();
    const auto [last, error] = std::from_chars(name_or_index.data(), end, index);
    if (error == std::errc() && last == end && index < count)
        return index;
    return {};
}

/// `0 "front", 1 "side"`: for a message that says what there is.
template <class NameOf>
std::string list_names(size_t count, NameOf name_of) {
    std::string list;
    for (size_t i = 0; i < count; ++i)
        list += fmt::format("{}{} \"{}\"", i ? ", " : "", i, name_of(i));
    return list;
}

} // namespace prelight
