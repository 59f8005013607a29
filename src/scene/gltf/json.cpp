#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <scene/gltf/json.hpp>

namespace prelight::gltf {
namespace dom = simdjson::dom;

std::string printable(std::string_view text) {
    constexpr size_t longest = 80;
    size_t length = std::min(text.size(), longest);
    while (length < text.size() && length > 0 && (text[length] & 0xc0) == 0x80)
        --length; // not within a character
    std::string out(text.substr(0, length));
    for (char& c : out)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            c = '?';
    return text.size() > longest ? out + "…" : out;
}

void fail(std::string_view file, std::string_view object, std::string_view reason) {
    throw Error(fmt::format("{}: {}: {}", file, object, reason));
}

Item::Item(std::string_view file, std::string label, dom::element element)
    : file_(file), label_(std::move(label)) {
    if (element.get(object_) != simdjson::SUCCESS)
        fail("is not a JSON object");
}

void Item::bad(std::string_view key, std::string_view reason) const {
    fail(fmt::format("{} {}", printable(key), reason));
}

std::optional<dom::element> Item::find(std::string_view key) const {
    dom::element value;
    if (object_.at_key(key).get(value) != simdjson::SUCCESS)
        return {};
    return value;
}

bool Item::has(std::string_view key) const {
    return find(key).has_value();
}

std::string Item::text(std::string_view key) const {
    const auto value = find(key);
    std::string_view text;
    if (value && value->get(text) != simdjson::SUCCESS)
        bad(key, "is not a string");
    return std::string(text);
}

bool Item::flag(std::string_view key, bool absent) const {
    const auto value = find(key);
    if (value && value->get(absent) != simdjson::SUCCESS)
        bad(key, "is not true or false");
    return absent;
}

double Item::number(std::string_view key, double absent) const {
    const auto value = find(key);
    if (value && value->get(absent) != simdjson::SUCCESS)
        bad(key, "is not a number");
    return absent;
}

float Item::real(std::string_view key, float absent) const {
    const auto value = float(number(key, absent));
    if (has(key) && !std::isfinite(value))
        bad(key, "is too large");
    return value;
}

uint64_t Item::to_integer(std::string_view key, dom::element value) const {
    uint64_t integer = 0;
    double real = 0;
    if (value.get(integer) == simdjson::SUCCESS)
        return integer;
    // Some exporters write 3.0 for 3.
    if (value.is_double() && value.get(real) == simdjson::SUCCESS && real >= 0 && real <= 0x1p53 &&
        real == std::floor(real))
        return uint64_t(real);
    bad(key, "is not a non-negative integer");
}

std::optional<uint64_t> Item::integer(std::string_view key) const {
    const auto value = find(key);
    return value ? std::optional(to_integer(key, *value)) : std::nullopt;
}

uint64_t Item::integer_or(std::string_view key, uint64_t absent) const {
    return integer(key).value_or(absent);
}

uint64_t Item::required_integer(std::string_view key) const {
    const auto value = integer(key);
    if (!value)
        bad(key, "is missing");
    return *value;
}

std::optional<uint32_t> Item::index(std::string_view key, size_t count) const {
    const auto value = integer(key);
    if (!value)
        return {};
    if (*value >= count)
        bad(key, fmt::format("is {}, but there are {}", *value, count));
    return uint32_t(*value);
}

uint32_t Item::required_index(std::string_view key, size_t count) const {
    const auto value = index(key, count);
    if (!value)
        bad(key, "is missing");
    return *value;
}

std::vector<uint32_t> Item::indices(std::string_view key, size_t count) const {
    const auto value = find(key);
    dom::array array;
    std::vector<uint32_t> out;
    if (!value)
        return out;
    if (value->get(array) != simdjson::SUCCESS)
        bad(key, "is not an array");
    for (const dom::element element : array) {
        const uint64_t i = to_integer(key, element);
        if (i >= count)
            bad(key, fmt::format("holds {}, but there are {}", i, count));
        out.push_back(uint32_t(i));
    }
    return out;
}

std::vector<float> Item::reals(std::string_view key) const {
    const auto value = find(key);
    dom::array array;
    std::vector<float> out;
    if (!value)
        return out;
    if (value->get(array) != simdjson::SUCCESS)
        bad(key, "is not an array");
    for (const dom::element element : array) {
        double number = 0;
        if (element.get(number) != simdjson::SUCCESS)
            bad(key, "holds something that is not a number");
        out.push_back(float(number));
        if (!std::isfinite(out.back()))
            bad(key, "holds a number that is too large");
    }
    return out;
}

void Item::read_numbers(std::string_view key, double* values, size_t count) const {
    const auto value = find(key);
    dom::array array;
    if (!value)
        return;
    if (value->get(array) != simdjson::SUCCESS)
        bad(key, "is not an array");
    size_t i = 0;
    for (const dom::element element : array) {
        if (i < count && element.get(values[i]) != simdjson::SUCCESS)
            bad(key, "holds something that is not a number");
        ++i;
    }
    if (i != count)
        bad(key, fmt::format("has {} numbers instead of {}", i, count));
}

std::optional<Item> Item::object(std::string_view key) const {
    const auto value = find(key);
    if (!value)
        return {};
    return Item(file_, fmt::format("{} {}", label_, printable(key)), *value);
}

std::optional<Item> Item::extension(std::string_view name) const {
    const auto value = find("extensions");
    if (!value)
        return {};
    const auto inner = Item(file_, label_, *value).find(name);
    if (!inner)
        return {};
    return Item(file_, fmt::format("{} {}", label_, name), *inner);
}

std::vector<Item> Item::items(std::string_view key, std::string_view singular) const {
    const auto value = find(key);
    dom::array array;
    std::vector<Item> out;
    if (!value)
        return out;
    if (value->get(array) != simdjson::SUCCESS)
        bad(key, "is not an array");
    for (const dom::element element : array)
        out.emplace_back(file_, fmt::format("{} {} {}", label_, singular, out.size()), element);
    return out;
}

std::vector<std::string> Item::texts(std::string_view key) const {
    const auto value = find(key);
    dom::array array;
    std::vector<std::string> out;
    if (!value)
        return out;
    if (value->get(array) != simdjson::SUCCESS)
        bad(key, "is not an array");
    for (const dom::element element : array) {
        std::string_view text;
        if (element.get(text) != simdjson::SUCCESS)
            bad(key, "holds something that is not a string");
        out.emplace_back(text);
    }
    return out;
}

} // namespace prelight::gltf
