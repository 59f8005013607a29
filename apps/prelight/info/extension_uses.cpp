#include "extension_uses.hpp"

#include <nlohmann/json.hpp>
#include <vector>

namespace prelight::app {
namespace {

/// Knows at each value under which keys it lies. Without a tree: a text may be nested deeply.
struct UseCounter final : nlohmann::json_sax<nlohmann::json> {
    ExtensionUses uses;
    std::vector<std::string> path; ///< of each open object and array the key that it has; empty in an array
    std::string name;              ///< of the value that comes next

    bool key(string_t& text) override {
        name = text;
        if (!path.empty() && path.back() == "extensions")
            ++uses.extensions[text].objects;
        return true;
    }
    bool string(string_t& text) override {
        if (path.size() == 2 && path[1] == "extensionsUsed")
            uses.extensions[text];
        else if (path.size() == 2 && path[1] == "extensionsRequired")
            uses.extensions[text].required = true;
        else if (path.size() == 2 && path[1] == "asset" && name == "generator")
            uses.generator = text;
        else if (path.size() == 2 && path[1] == "asset" && name == "version")
            uses.version = text;
        return end_value();
    }
    bool start_object(std::size_t) override { return open(); }
    bool start_array(std::size_t) override { return open(); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool null() override { return end_value(); }
    bool boolean(bool) override { return end_value(); }
    bool number_integer(number_integer_t) override { return end_value(); }
    bool number_unsigned(number_unsigned_t) override { return end_value(); }
    bool number_float(number_float_t, const string_t&) override { return end_value(); }
    bool binary(binary_t&) override { return end_value(); }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

private:
    bool open() {
        path.push_back(std::move(name));
        return end_value();
    }
    bool close() {
        path.pop_back();
        return end_value();
    }
    bool end_value() {
        name.clear();
        return true;
    }
};

} // namespace

ExtensionUses extension_uses(std::string_view json) {
    UseCounter counter;
    nlohmann::json::sax_parse(json, &counter, nlohmann::json::input_format_t::json, false);
    return std::move(counter.uses);
}

} // namespace prelight::app
