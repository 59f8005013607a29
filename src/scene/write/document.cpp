#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <scene/write/document.hpp>

namespace prelight::write {

void Document::fail(std::string_view object, std::string_view reason) const {
    throw Error(fmt::format("{}: {}: {}", file, object, reason));
}

uint32_t Document::add(const char* list, Json element) {
    Json& array = root[list];
    array.push_back(std::move(element));
    return static_cast<uint32_t>(array.size() - 1);
}

void Document::use(const char* extension) {
    Json& used = root["extensionsUsed"];
    if (std::find(used.begin(), used.end(), extension) == used.end())
        used.push_back(extension);
}

uint32_t Document::add_view(std::span<const std::byte> bytes, ViewKind kind) {
    binary.resize((binary.size() + 3) / 4 * 4);
    Json view{{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}};
    if (kind != ViewKind::other)
        view["target"] = static_cast<int>(kind);
    binary.insert(binary.end(), bytes.begin(), bytes.end());
    return add("bufferViews", std::move(view));
}

uint32_t Document::add_accessor(uint32_t view, int component, const char* type, size_t count) {
    return add("accessors", {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
}

Json number(float value) {
    const double decimal = std::strtod(fmt::format("{}", value).c_str(), nullptr);
    return static_cast<float>(decimal) == value ? decimal : static_cast<double>(value);
}

Json reals(const std::vector<float>& values) {
    Json list = Json::array();
    for (const float value : values)
        list.push_back(number(value));
    return list;
}

void set_name(Json& object, const std::string& name) {
    if (!name.empty())
        object["name"] = name;
}

std::string label(std::string_view kind, size_t index, const std::string& name) {
    return name.empty() ? fmt::format("{} {}", kind, index) : fmt::format("{} {} ({})", kind, index, name);
}

} // namespace prelight::write
