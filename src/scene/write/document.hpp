#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace prelight::write {

/// Members keep the order in which they are set: the same scene gives the same bytes.
using Json = nlohmann::ordered_json;

/// What a buffer view holds (bufferView.target); `other` has no target.
enum class ViewKind { other = 0, vertices = 34962, indices = 34963 };

/// A glTF file in the making: the JSON tree and the binary chunk that it refers to.
/// Arrays in glTF are never empty, so every one is made by its first element.
class Document {
public:
    explicit Document(std::string file_name) : file(std::move(file_name)) {}

    Json root = Json::object();
    std::vector<std::byte> binary;

    const std::string& name() const { return file; }
    /// Throws Error "FILE: OBJECT: REASON".
    [[noreturn]] void fail(std::string_view object, std::string_view reason) const;

    /// Appends to the root's array `list` and returns the element's index.
    uint32_t add(const char* list, Json element);
    /// Lists the extension in `extensionsUsed`, once.
    void use(const char* extension);
    /// Copies the bytes to the binary chunk, aligned to 4.
    uint32_t add_view(std::span<const std::byte> bytes, ViewKind kind);
    /// `component`: 5126 float, 5125 uint32, 5123 uint16; `type`: "SCALAR", "VEC3" …
    uint32_t add_accessor(uint32_t view, int component, const char* type, size_t count);
    template <int N>
    uint32_t add_vectors(const std::vector<glm::vec<N, float>>& values, ViewKind kind) {
        constexpr std::array types{"VEC2", "VEC3", "VEC4"};
        return add_accessor(add_view(std::as_bytes(std::span(values)), kind), 5126, types[N - 2], values.size());
    }

private:
    std::string file;
};

/// The shortest decimal that reads back as the same float. The value must be finite: JSON knows no
/// other numbers.
Json number(float value);
template <int N>
Json numbers(const glm::vec<N, float>& v) {
    Json list = Json::array();
    for (int i = 0; i < N; ++i)
        list.push_back(number(v[i]));
    return list;
}
Json reals(const std::vector<float>& values);
/// Sets "name" unless it is empty.
void set_name(Json& object, const std::string& name);
/// "material 3 (wood)", for messages.
std::string label(std::string_view kind, size_t index, const std::string& name);

} // namespace prelight::write
