#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <platform/file_bytes.hpp>
#include <prelight/scene_io.hpp>
#include <scene/gltf/budget.hpp>
#include <scene/gltf/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace prelight::gltf {

using Bytes = std::vector<uint8_t>;

/// A file that is charged to the budget when it has been read. Throws FileError.
FileBytes read_within(const Budget& budget, const std::filesystem::path& file, size_t padding = 0);

/// The top-level arrays that the reader uses.
enum class Table {
    buffers,
    buffer_views,
    accessors,
    images,
    samplers,
    textures,
    materials,
    meshes,
    cameras,
    lights,
    nodes,
    scenes,
    skins,
    animations
};
inline constexpr size_t table_count = 14;

/// The file's JSON and binary chunk, its limits, and the warnings that gather while it is read.
class Document {
public:
    /// Splits a .glb, parses the JSON, checks version and extensions. `file` is the name in messages,
    /// `folder` where relative URIs lead; `bytes` end in SIMDJSON_PADDING more than the file has; `memory`: of the
    /// budget.
    Document(std::string file, std::filesystem::path folder, FileBytes bytes, const LoadOptions& options,
             uint64_t memory);
    Document(const Document&) = delete;
    Document& operator=(const Document&) = delete;

    const std::string& file() const { return warnings_.file(); }
    const Item& root() const { return *root_; }
    size_t count(Table table) const { return tables_[size_t(table)].size(); }
    /// The object `i` of a table, named as in messages ("node 3"). `i` < count(table).
    Item item(Table table, size_t i) const;
    std::string label(Table table, size_t i) const;
    bool uses(std::string_view extension) const; ///< the file lists it as used or required
    /// The .glb's BIN chunk; empty when there is none.
    std::span<const uint8_t> binary_chunk() const { return binary_; }
    /// Reads a data: URI or a file beside the scene; both stay owned by the document. A file is
    /// read once however many objects name it. Throws UriError with what the URI says and the reason; warns for
    /// `object` where the file has the URI's name as it is written.
    std::span<const uint8_t> read_uri(const std::string& uri, const std::string& object);

    /// Charges for memory that `object` is about to take; throws Error when it is too much.
    void charge(const std::string& object, uint64_t count, uint64_t size);
    Budget& budget() { return budget_; }
    [[noreturn]] void fail(std::string_view object, std::string_view reason) const {
        gltf::fail(file(), object, reason);
    }

    /// Counts one more object with this trouble; they end in one line a kind. Item::warn says more.
    void warn(const std::string& kind, const std::string& object) { warnings_.add(kind, object, kind); }
    const Warnings& warnings() const { return warnings_; }

private:
    void split_glb();
    void check_text(std::span<const uint8_t> all) const;
    void parse(std::span<const uint8_t> json);
    void check_version() const;
    void check_extensions();

    /// Every object of the file holds on to it, const or not: a warning changes nothing that is read.
    mutable Warnings warnings_;
    std::filesystem::path folder_;
    Budget budget_;
    FileBytes bytes_;
    std::span<const uint8_t> binary_;
    simdjson::dom::parser parser_;
    std::optional<Item> root_;
    std::array<std::vector<simdjson::dom::element>, table_count> tables_;
    std::vector<std::string> extensions_;    ///< used and required
    std::map<std::string, FileBytes> files_; ///< by canonical path
    std::vector<std::unique_ptr<Bytes>> data_uris_;
};

} // namespace prelight::gltf
