#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <scene/gltf/json_mistake.hpp>

namespace prelight::gltf {
namespace {

/// Keeps nothing of the text but how far it is good: the reader's own parser does not say.
struct Finder {
    using Json = nlohmann::json;
    size_t bytes = 0; ///< read up to the mistake, with it; 0: there is none

    bool null() { return true; }
    bool boolean(bool) { return true; }
    bool number_integer(Json::number_integer_t) { return true; }
    bool number_unsigned(Json::number_unsigned_t) { return true; }
    bool number_float(Json::number_float_t, const std::string&) { return true; }
    bool string(std::string&) { return true; }
    bool binary(Json::binary_t&) { return true; }
    bool start_object(size_t) { return true; }
    bool key(std::string&) { return true; }
    bool end_object() { return true; }
    bool start_array(size_t) { return true; }
    bool end_array() { return true; }
    bool parse_error(size_t position, const std::string&, const nlohmann::detail::exception&) {
        bytes = std::max<size_t>(position, 1);
        return false;
    }
};

} // namespace

std::string place_of_mistake(std::span<const uint8_t> text) {
    Finder finder;
    if (nlohmann::json::sax_parse(text.begin(), text.end(), &finder) || finder.bytes == 0)
        return {};
    const auto before = text.first(std::min(finder.bytes - 1, text.size()));
    const auto lines = std::count(before.begin(), before.end(), '\n');
    const auto line = std::find(before.rbegin(), before.rend(), '\n');
    return fmt::format("line {}, column {}", lines + 1, (line - before.rbegin()) + 1);
}

} // namespace prelight::gltf
