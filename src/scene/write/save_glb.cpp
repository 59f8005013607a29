#include <fmt/format.h>
#include <limits>
#include <platform/atomic_file.hpp>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <scene/write/parts.hpp>

namespace prelight {
namespace {

using write::Document;
using write::Json;

Document make_document(const Scene& scene, const std::filesystem::path& path) {
    Document document(path.string());
    document.root["asset"] = {{"version", "2.0"}, {"generator", "Prelight"}};
    if (scene.ambient != glm::vec3(0))
        document.root["extras"]["prelight"]["ambient"] = write::numbers(scene.ambient);
    write::add_cameras(scene, document);
    write::add_lights(scene, document);
    write::add_materials(scene, document);
    const auto meshes = write::add_meshes(scene, document);
    write::add_images(scene, document);
    write::add_nodes(scene, meshes, document);
    write::add_skins(scene, document);
    write::add_animations(scene, meshes, document);
    if (!document.binary.empty())
        document.add("buffers", {{"byteLength", document.binary.size()}});
    return document;
}

template <size_t N>
void put_words(AtomicFile& file, const std::array<uint32_t, N>& words) {
    static_assert(std::endian::native == std::endian::little, "GLB is little-endian");
    file.write(words.data(), sizeof words);
}

} // namespace

void save_glb(const Scene& scene, const std::filesystem::path& path) {
    AtomicFile file(path); // first, so that a wrong path is told before the work is done
    Document document = make_document(scene, path);
    // Names come from anywhere: what is not UTF-8 is replaced.
    std::string json = document.root.dump(-1, ' ', false, Json::error_handler_t::replace);
    json.resize((json.size() + 3) / 4 * 4, ' ');
    document.binary.resize((document.binary.size() + 3) / 4 * 4);

    constexpr uint64_t header = 12, chunk_header = 8;
    const uint64_t length =
        header + chunk_header + json.size() + (document.binary.empty() ? 0 : chunk_header + document.binary.size());
    if (length > std::numeric_limits<uint32_t>::max())
        document.fail("scene", fmt::format("{} bytes do not fit a .glb file (4 GiB)", length));
    const auto size = [](const auto& chunk) { return static_cast<uint32_t>(chunk.size()); };
    put_words<3>(file, {0x46546c67, 2, static_cast<uint32_t>(length)}); // "glTF", version
    put_words<2>(file, {size(json), 0x4e4f534a});                       // "JSON"
    file.write(json.data(), json.size());
    if (!document.binary.empty()) {
        put_words<2>(file, {size(document.binary), 0x004e4942}); // "BIN\0"
        file.write(document.binary);
    }
    file.commit();
}

} // namespace prelight
