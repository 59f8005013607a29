#pragma once
#include <array>
#include <cstdint>
#include <fmt/format.h>
#include <optional>
#include <prelight/error.hpp>
#include <scene/warnings.hpp>
#include <simdjson.h>
#include <string>
#include <string_view>
#include <vector>

namespace prelight::gltf {

/// Text from a file made fit for a one-line message: escaped, and cut where it is long.
std::string printable(std::string_view text);

/// Throws Error "FILE: OBJECT: REASON".
[[noreturn]] void fail(std::string_view file, std::string_view object, std::string_view reason);

/// One JSON object of the file with the name it has in messages, for example "material 3". Every
/// getter checks type and range. What numbers and words are good for (an object's looks) is repaired: a value of
/// the wrong kind counts as absent, with a warning. Integers and indices are what the file hangs together by:
/// a wrong one throws Error "FILE: OBJECT: KEY …". `warnings` outlives it.
class Item {
public:
    Item(Warnings& warnings, std::string label, simdjson::dom::element element);

    const std::string& label() const { return label_; }
    std::string_view file() const { return warnings_->file(); }
    [[noreturn]] void fail(std::string_view reason) const { gltf::fail(file(), label_, reason); }
    /// Says what was repaired or left out, and why. Warnings with the same pattern become one line.
    template <class... Args>
    void warn(fmt::format_string<Args...> pattern, Args&&... args) const {
        const fmt::string_view kind = pattern;
        warnings_->add({kind.data(), kind.size()}, label_, fmt::format(pattern, std::forward<Args>(args)...));
    }
    Warnings& warnings() const { return *warnings_; }

    bool has(std::string_view key) const;
    std::string text(std::string_view key) const; ///< empty when absent
    bool flag(std::string_view key, bool absent = false) const;
    double number(std::string_view key, double absent) const;
    float real(std::string_view key, float absent) const; ///< finite as float
    /// Within low … high; a value beyond is taken for the nearest within, with a warning.
    float real_within(std::string_view key, float absent, float low, float high) const;
    std::optional<uint64_t> integer(std::string_view key) const; ///< non-negative
    uint64_t integer_or(std::string_view key, uint64_t absent) const;
    uint64_t required_integer(std::string_view key) const;
    /// An index below `count`.
    std::optional<uint32_t> index(std::string_view key, size_t count) const;
    uint32_t required_index(std::string_view key, size_t count) const;
    /// An array of indices below `count`; empty when absent.
    std::vector<uint32_t> indices(std::string_view key, size_t count) const;
    std::vector<float> reals(std::string_view key) const; ///< finite, others are 0; empty when absent
    /// An array of exactly N numbers.
    template <size_t N>
    std::array<double, N> numbers(std::string_view key, std::array<double, N> absent) const {
        std::array<double, N> values = absent;
        return read_numbers(key, values.data(), N) ? values : absent;
    }
    /// Each within low … high, as real_within().
    template <size_t N>
    std::array<double, N> numbers_within(std::string_view key, std::array<double, N> absent, double low,
                                         double high) const {
        std::array<double, N> values = numbers(key, absent);
        for (double& value : values)
            value = within(key, value, low, high);
        return values;
    }
    /// The object under `key`, named "LABEL KEY".
    std::optional<Item> object(std::string_view key) const;
    std::optional<Item> extension(std::string_view name) const;
    /// The objects in the array under `key`, named "LABEL SINGULAR i".
    std::vector<Item> items(std::string_view key, std::string_view singular) const;
    std::vector<std::string> texts(std::string_view key) const; ///< array of strings

    /// The value as it is, or nothing.
    std::optional<simdjson::dom::element> find(std::string_view key) const;

private:
    [[noreturn]] void bad(std::string_view key, std::string_view reason) const;
    /// The value's kind is wrong: says what stands there and that it does not count.
    void ignore(std::string_view key, std::string_view wanted, simdjson::dom::element value) const;
    bool read_numbers(std::string_view key, double* values, size_t count) const;
    double within(std::string_view key, double value, double low, double high) const;
    uint64_t to_integer(std::string_view key, simdjson::dom::element value) const;

    Warnings* warnings_;
    std::string label_;
    simdjson::dom::object object_;
};

} // namespace prelight::gltf
