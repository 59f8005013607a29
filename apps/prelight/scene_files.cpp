#include "scene_files.hpp"

#include "scene_source.hpp"

#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <scene/gltf/uri.hpp>

namespace prelight::app {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t most_text = uint64_t(1) << 30;

/// Collects values of the keys under which the reader looks for files. Without a tree: a text may be nested deeply.
struct Collector final : nlohmann::json_sax<nlohmann::json> {
    std::vector<std::string> uris;
    bool names_file = false;

    bool key(string_t& name) override {
        names_file = name == "uri" || name == "ies";
        return true;
    }
    bool string(string_t& text) override {
        if (names_file && !gltf::is_data_uri(text))
            uris.push_back(text);
        return true;
    }
    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override { return true; }
    bool end_object() override { return true; }
    bool start_array(std::size_t) override { return true; }
    bool end_array() override { return true; }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }
};

} // namespace

std::string json_of(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error))
        return {};
    const uint64_t size = fs::file_size(file, error);
    std::ifstream stream(file, std::ios::binary);
    char header[20] = {};
    stream.read(header, sizeof header);
    uint64_t length = size;
    if (stream && std::memcmp(header, "glTF", 4) == 0) {
        uint32_t chunk = 0;
        std::memcpy(&chunk, header + 12, sizeof chunk);
        length = std::min<uint64_t>(chunk, size - sizeof header);
    } else {
        stream.clear();
        stream.seekg(0);
    }
    if (error || length > most_text)
        return {};
    std::string text(length, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(length));
    text.resize(static_cast<size_t>(stream.gcount()));
    return text;
}

std::vector<fs::path> files_named_in(const std::string& scene) {
    if (!names_file(scene))
        return {};
    Collector collector;
    nlohmann::json::sax_parse(json_of(scene), &collector, nlohmann::json::input_format_t::json, false);
    std::vector<fs::path> files;
    for (const std::string& uri : collector.uris) {
        try {
            files.push_back(gltf::resolve_uri(fs::path(scene).parent_path(), uri).path);
        } catch (const gltf::UriError&) {
            // The reader will say so.
        }
    }
    return files;
}

} // namespace prelight::app
