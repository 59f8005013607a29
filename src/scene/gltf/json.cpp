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
    const std::string out = escaped(text.substr(0, length));
    return text.size() > longest ? out + "…" : out;
}

void fail(std::string_view file, std::string_view object, std::string_view reason) {
    throw Error(fmt::format("{}: {}: {}", file, object, reason));
}

Item::Item(Warnings& warnings, std::string label, dom::element element)
    : warnings_(&warnings), label_(std::move(label)) {
    if (element.get(object_) != simdjson::SUCCESS)
        fail("is not a JSON object");
}

void Item::bad(std::string_view key, std::string_view reason) const {
    fail(fmt::format("{} {}", printable(key), reason));
}

void Item::ignore(std::string_view key, std::string_view wanted, dom::element value) const {
    const std::string text = value.is_array()    ? "another array"
                             : value.is_object() ? "an object"
                                                 : simdjson::minify(value);
    warn("{} is {}, not {}; it is ignored", printable(key), printable(text), wanted);
}

std::optional<dom::element> Item::find(std::string_view key) const {
    dom::element value;
    if (object_.at_key(key).get(value) != simdjson::SUCCESS)
        return {};
    return value;
}

bool Item::has(std::string_view key) const { return find(key).has_value(); }

std::string Item::text(std::string_view key) const {
    const auto value = find(key);
    std::string_view text;
    if (value && value->get(text) != simdjson::SUCCESS)
        ignore(key, "a string", *value);
    return std::string(text);
}

bool Item::flag(std::string_view key, bool absent) const {
    const auto value = find(key);
    if (value && value->get(absent) != simdjson::SUCCESS)
        ignore(key, "true or false", *value);
    return absent;
}

double Item::number(std::string_view key, double absent) const {
    const auto value = find(key);
    if (value && value->get(absent) != simdjson::SUCCESS)
        ignore(key, "a number", *value);
    return absent;
}

float Item::real(std::string_view key, float absent) const {
    const auto value = float(number(key, absent));
    if (std::isfinite(value) || !has(key))
        return value;
    ignore(key, "a number that fits into 32 bits", *find(key));
    return absent;
}

double Item::within(std::string_view key, double value, double low, double high) const {
    if (value >= low && value <= high)
        return value;
    const double nearest = std::clamp(value, low, high);
    warn("{} is {}, outside {:.6g} … {:.6g}; {:.6g} is used", printable(key), value, low, high, nearest);
    return nearest;
}

float Item::real_within(std::string_view key, float absent, float low, float high) const {
    return has(key) ? float(within(key, double(real(key, absent)), low, high)) : absent;
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

uint64_t Item::integer_or(std::string_view key, uint64_t absent) const { return integer(key).value_or(absent); }

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
    if (value->get(array) != simdjson::SUCCESS) {
        ignore(key, "an array of numbers", *value);
        return out;
    }
    for (const dom::element element : array) {
        double number = 0;
        if (element.get(number) != simdjson::SUCCESS || !std::isfinite(float(number))) {
            warn("{} {} is no number that fits into 32 bits; 0 is used", printable(key), out.size());
            number = 0;
        }
        out.push_back(float(number));
    }
    return out;
}

bool Item::read_numbers(std::string_view key, double* values, size_t count) const {
    const auto value = find(key);
    dom::array array;
    if (!value)
        return true;
    bool good = value->get(array) == simdjson::SUCCESS;
    size_t i = 0;
    if (good)
        for (const dom::element element : array) {
            good = good && (i >= count || element.get(values[i]) == simdjson::SUCCESS);
            ++i;
        }
    constexpr size_t longest_vector =
        4; // of a colour with or without alpha, what is there counts; half a matrix does not
    if (!good || (i != count && (count > longest_vector || i == 0)))
        ignore(key, fmt::format("an array of {} numbers", count), *value);
    else if (i != count)
        warn("{} has {} numbers instead of {}; the first {} count", printable(key), i, count, std::min(i, count));
    return good && (i == count || (i > 0 && count <= longest_vector));
}

std::optional<Item> Item::object(std::string_view key) const {
    const auto value = find(key);
    if (!value)
        return {};
    return Item(*warnings_, fmt::format("{} {}", label_, printable(key)), *value);
}

std::optional<Item> Item::extension(std::string_view name) const {
    const auto value = find("extensions");
    if (!value)
        return {};
    const auto inner = Item(*warnings_, label_, *value).find(name);
    if (!inner)
        return {};
    return Item(*warnings_, fmt::format("{} {}", label_, name), *inner);
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
        out.emplace_back(*warnings_, fmt::format("{} {} {}", label_, singular, out.size()), element);
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
