#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <platform/read_file.hpp>
#include <scene/gltf/document.hpp>
#include <scene/gltf/extensions.hpp>
#include <scene/gltf/json_mistake.hpp>
#include <scene/gltf/uri.hpp>

namespace prelight::gltf {
namespace {
namespace fs = std::filesystem;

/// Nesting that the parser follows; real files stay below 20.
constexpr size_t max_depth = 128;
/// simdjson's tape, strings and indices take up to 15 bytes per byte of JSON, our tables up to 8.
constexpr uint64_t json_cost = 24;

constexpr std::array<std::pair<const char*, const char*>, table_count> table_names{{
    {"buffers", "buffer"},
    {"bufferViews", "bufferView"},
    {"accessors", "accessor"},
    {"images", "image"},
    {"samplers", "sampler"},
    {"textures", "texture"},
    {"materials", "material"},
    {"meshes", "mesh"},
    {"cameras", "camera"},
    {"lights", "light"},
    {"nodes", "node"},
    {"scenes", "scene"},
    {"skins", "skin"},
    {"animations", "animation"},
}};

uint32_t read_u32(std::span<const uint8_t> bytes, size_t at) {
    uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

std::span<const uint8_t> without_byte_order_mark(std::span<const uint8_t> text) {
    constexpr uint8_t mark[] = {0xef, 0xbb, 0xbf};
    return text.size() >= 3 && std::memcmp(text.data(), mark, 3) == 0 ? text.subspan(3) : text;
}

} // namespace

FileBytes read_within(const Budget& budget, const fs::path& file, size_t padding) {
    const uint64_t room = budget.room_for_input();
    if (room >= largest_file::scene)
        return read_bytes(file, largest_file::scene, padding);
    std::error_code none;
    if (const uint64_t size = fs::file_size(file, none); !none && size > room && size <= largest_file::scene)
        throw FileError(fmt::format("needs more memory than the memory limit allows ({} MiB, {} MiB left for files)",
                                    size >> 20, room >> 20));
    return read_bytes(file, room, padding);
}

Document::Document(std::string file, fs::path folder, FileBytes bytes, const LoadOptions& options, uint64_t memory)
    : warnings_(std::move(file), options.strict), folder_(std::move(folder)), budget_(memory),
      bytes_(std::move(bytes)) {
    budget_.add_input(bytes_.size() - simdjson::SIMDJSON_PADDING);
    split_glb();
    check_extensions();
}

void Document::split_glb() {
    const std::span<const uint8_t> all(bytes_.data(), bytes_.size() - simdjson::SIMDJSON_PADDING);
    if (all.size() < 4 || std::memcmp(all.data(), "glTF", 4) != 0) {
        check_text(all);
        return parse(all);
    }
    if (all.size() < 12)
        fail("header", "the file is truncated");
    if (const uint32_t version = read_u32(all, 4); version != 2)
        fail("header", fmt::format("the file is binary glTF {}.0; only glTF 2.0 is read", version));
    const uint32_t length = read_u32(all, 8);
    if (length > all.size())
        fail("header", fmt::format("the file is truncated: {} of {} bytes", all.size(), length));
    constexpr uint32_t json_type = 0x4e4f534a, bin_type = 0x004e4942;
    std::span<const uint8_t> json;
    size_t at = 12;
    for (uint32_t chunk = 0; at < length; ++chunk) {
        if (length - at < 8)
            fail(fmt::format("chunk {}", chunk), "its header is cut short");
        const uint32_t size = read_u32(all, at), type = read_u32(all, at + 4);
        at += 8;
        if (size > length - at)
            fail(fmt::format("chunk {}", chunk),
                 fmt::format("its length {} is beyond the file's end ({} bytes left)", size, length - at));
        if (chunk == 0 && type != json_type)
            fail("chunk 0", "is not JSON");
        if (chunk == 0)
            json = all.subspan(at, size);
        else if (chunk == 1 && type == bin_type)
            binary_ = all.subspan(at, size);
        at += size;
        at = std::min<size_t>((at + 3) & ~size_t(3), length);
    }
    if (json.empty())
        fail("chunk 0", "there is no JSON");
    parse(json);
}

void Document::check_text(std::span<const uint8_t> all) const {
    if (all.empty())
        fail("file", "is empty");
    all = without_byte_order_mark(all);
    const auto first =
        std::find_if(all.begin(), all.end(), [](uint8_t c) { return c != ' ' && c != '\t' && c != '\n' && c != '\r'; });
    if (first == all.end() || *first != '{')
        fail("file", "is no glTF file: it is neither GLB nor a JSON object");
}

void Document::parse(std::span<const uint8_t> json) {
    charge("JSON", json.size(), json_cost);
    json = without_byte_order_mark(json);
    // A little capacity even for nothing: simdjson reports an empty text as such.
    simdjson::error_code error = parser_.allocate(std::max<size_t>(json.size(), 64), max_depth);
    simdjson::dom::element top;
    if (!error)
        error = parser_.parse(json.data(), json.size(), false).get(top);
    if (error == simdjson::DEPTH_ERROR)
        fail("JSON", fmt::format("is nested deeper than {}", max_depth));
    if (error == simdjson::UTF8_ERROR)
        fail("JSON", "is not UTF-8");
    if (error == simdjson::MEMALLOC || error == simdjson::CAPACITY)
        fail("JSON", "there is not enough memory to read it");
    if (error) {
        const std::string place = place_of_mistake(json);
        fail("JSON",
             place.empty() ? "is damaged" : fmt::format("is damaged: what stands at {} does not belong there", place));
    }
    root_.emplace(warnings_, "JSON", top);
    check_version();
    for (size_t t = 0; t < table_count; ++t) {
        std::optional<Item> holder = *root_;
        if (Table(t) == Table::lights)
            holder = root_->extension("KHR_lights_punctual");
        const auto value = holder ? holder->find(table_names[t].first) : std::nullopt;
        simdjson::dom::array array;
        if (!value)
            continue;
        if (value->get(array) != simdjson::SUCCESS)
            fail("JSON", fmt::format("{} is not an array", table_names[t].first));
        for (const simdjson::dom::element element : array)
            tables_[t].push_back(element);
    }
}

/// Tables were objects before glTF 2.0, and the version need not stand anywhere.
void Document::check_version() const {
    const auto asset = root_->object("asset");
    const bool old = std::any_of(table_names.begin(), table_names.end(), [&](const auto& name) {
        const auto table = root_->find(name.first);
        return table && table->is_object();
    });
    if (!asset)
        fail("asset", old ? "is missing, and tables are objects: the file is glTF 1.0 or older; only glTF 2.0 is read"
                          : "is missing: the file's JSON is no glTF 2.0");
    std::string version;
    if (const auto given = asset->find("version"); given && given->is_number()) {
        version = fmt::format("{:.1f}", asset->number("version", 0));
        asset->warn("version is a number instead of a string");
    } else {
        version = asset->text("version");
    }
    const std::string least = asset->text("minVersion");
    if (version.empty())
        fail("asset",
             old ? "has no version, and tables are objects: the file is glTF 1.0 or older; only glTF 2.0 is read"
                 : "has no version; only glTF 2.0 is read");
    if (version.substr(0, 2) != "2.")
        fail("asset", fmt::format("the file is glTF {}; only glTF 2.0 is read", printable(version)));
    if (!least.empty() && least != "2.0")
        fail("asset", fmt::format("the file needs glTF {}; only glTF 2.0 is read", printable(least)));
}

void Document::check_extensions() {
    const auto known = [](const std::string& name) { return find_extension(name).honoured != Honoured::not_at_all; };
    extensions_ = root_->texts("extensionsUsed");
    const std::vector<std::string> required = root_->texts("extensionsRequired");
    extensions_.insert(extensions_.end(), required.begin(), required.end());
    for (const std::string& name : required)
        if (!known(name))
            fail(fmt::format("extension {}", printable(name)), "the file requires it, and it is not supported");
    std::string unknown;
    size_t count = 0;
    for (const std::string& name : root_->texts("extensionsUsed"))
        if (!known(name) && ++count <= 8)
            unknown += (count > 1 ? ", " : "") + printable(name);
    if (count > 0)
        warn("not supported, left out", unknown + (count > 8 ? " and others" : ""));
}

std::string Document::label(Table table, size_t i) const {
    return fmt::format("{} {}", table_names[size_t(table)].second, i);
}

bool Document::uses(std::string_view extension) const {
    return std::find(extensions_.begin(), extensions_.end(), extension) != extensions_.end();
}

Item Document::item(Table table, size_t i) const { return Item(warnings_, label(table, i), tables_[size_t(table)][i]); }

std::span<const uint8_t> Document::read_uri(const std::string& uri, const std::string& object) {
    if (is_data_uri(uri)) {
        charge(object, data_uri_size(uri), 1);
        return *data_uris_.emplace_back(std::make_unique<Bytes>(decode_data_uri(uri)));
    }
    const FoundFile target = resolve_uri(folder_, uri);
    if (!target.warning.empty())
        warn(target.warning, object);
    auto found = files_.find(target.path.string());
    if (found == files_.end()) {
        try {
            found = files_.emplace(target.path.string(), read_within(budget_, target.path)).first;
        } catch (const FileError& error) {
            throw UriError(fmt::format("\"{}\" {}", printable(uri), error.what()));
        }
        budget_.add_input(found->second.size());
    }
    return found->second;
}

void Document::charge(const std::string& object, uint64_t count, uint64_t size) {
    try {
        budget_.charge(Budget::Pool::geometry, count, size);
    } catch (const Budget::Exceeded& error) {
        fail(object, error.what());
    }
}

} // namespace prelight::gltf
