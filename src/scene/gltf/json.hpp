#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <prelight/error.hpp>
#include <simdjson.h>
#include <string>
#include <string_view>
#include <vector>

namespace prelight::gltf {

/// Text from a file made fit for a one-line message: control characters become '?', long text is
/// cut.
std::string printable(std::string_view text);

/// Throws Error "FILE: OBJECT: REASON".
[[noreturn]] void fail(std::string_view file, std::string_view object, std::string_view reason);

/// One JSON object of the file with the name it has in messages, for example "material 3". Every
/// getter checks type and range and throws Error "FILE: OBJECT: KEY …". `file` outlives it.
class Item {
public:
    Item(std::string_view file, std::string label, simdjson::dom::element element);

    const std::string& label() const { return label_; }
    std::string_view file() const { return file_; }
    [[noreturn]] void fail(std::string_view reason) const { gltf::fail(file_, label_, reason); }

    bool has(std::string_view key) const;
    std::string text(std::string_view key) const; ///< empty when absent
    bool flag(std::string_view key, bool absent = false) const;
    double number(std::string_view key, double absent) const;
    float real(std::string_view key, float absent) const;        ///< finite as float
    std::optional<uint64_t> integer(std::string_view key) const; ///< non-negative
    uint64_t integer_or(std::string_view key, uint64_t absent) const;
    uint64_t required_integer(std::string_view key) const;
    /// An index below `count`.
    std::optional<uint32_t> index(std::string_view key, size_t count) const;
    uint32_t required_index(std::string_view key, size_t count) const;
    /// An array of indices below `count`; empty when absent.
    std::vector<uint32_t> indices(std::string_view key, size_t count) const;
    std::vector<float> reals(std::string_view key) const; ///< finite; empty when absent
    /// An array of exactly N numbers.
    template <size_t N>
    std::array<double, N> numbers(std::string_view key, std::array<double, N> absent) const {
        read_numbers(key, absent.data(), N);
        return absent;
    }
    /// The object under `key`, named "LABEL KEY".
    std::optional<Item> object(std::string_view key) const;
    std::optional<Item> extension(std::string_view name) const;
    /// The objects in the array under `key`, named "LABEL SINGULAR i".
    std::vector<Item> items(std::string_view key, std::string_view singular) const;
    std::vector<std::string> texts(std::string_view key) const;     ///< array of strings

    /// The value as it is, or nothing.
    std::optional<simdjson::dom::element> find(std::string_view key) const;

private:
    [[noreturn]] void bad(std::string_view key, std::string_view reason) const;
    void read_numbers(std::string_view key, double* values, size_t count) const;
    uint64_t to_integer(std::string_view key, simdjson::dom::element value) const;

    std::string_view file_;
    std::string label_;
    simdjson::dom::object object_;
};

} // namespace prelight::gltf
