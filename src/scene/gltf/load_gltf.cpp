#include <new>
#include <platform/read_file.hpp>
#include <platform/spare_memory.hpp>
#include <prelight/scene_io.hpp>
#include <scene/gltf/animations.hpp>
#include <scene/gltf/extras.hpp>
#include <scene/gltf/load.hpp>
#include <scene/gltf/nodes.hpp>
#include <scene/gltf/primitives.hpp>
#include <scene/gltf/textures.hpp>
#include <scene/gltf/uri.hpp>

namespace prelight {
namespace {

/// In an order in which everything that an object names has been read before it.
Scene read_scene(gltf::Document&& document) {
    Scene scene;
    scene.name = document.file();
    gltf::Buffers buffers(document);
    gltf::Accessors accessors(document, buffers);
    gltf::Textures textures(document, buffers, scene);
    gltf::read_materials(document, textures, scene);
    gltf::read_meshes(document, buffers, accessors, scene);
    const gltf::Places cameras = gltf::read_cameras(document, scene);
    const gltf::Places lights = gltf::read_lights(document, scene);
    gltf::read_extras(document, buffers, textures, lights, scene);
    gltf::read_nodes(document, accessors, cameras, lights, scene);
    gltf::read_scenes(document, scene);
    gltf::read_skins(document, accessors, scene);
    gltf::read_animations(document, accessors, scene);
    textures.tell_scaled();
    if (scene.materials.empty()) // a file of lights and cameras; renderers want one
        scene.materials.emplace_back().name = "default";
    scene.warnings = document.warnings().lines();
    return scene;
}

/// What the limits let through may still be more than the machine has.
template <class Read>
Scene guard_memory(const std::string& file, Read read) {
    try {
        return read();
    } catch (const std::bad_alloc&) {
        gltf::fail(file, "memory", "there is not enough to read the file");
    } catch (const std::length_error&) {
        gltf::fail(file, "memory", "there is not enough to read the file");
    }
}

uint64_t memory_of(const LoadOptions& options) {
    return options.memory_limit != 0 ? options.memory_limit : spare_memory();
}

} // namespace

Scene gltf::load(std::span<const uint8_t> bytes, const std::string& file, const std::filesystem::path& folder,
                 const LoadOptions& options) {
    return guard_memory(file, [&] {
        FileBytes padded(bytes.begin(), bytes.end());
        padded.resize(bytes.size() + simdjson::SIMDJSON_PADDING, 0);
        return read_scene(Document(file, folder, std::move(padded), options, memory_of(options)));
    });
}

Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options) {
    const std::string file = path.string();
    return guard_memory(file, [&] {
        const uint64_t memory = memory_of(options);
        FileBytes bytes;
        try {
            bytes = gltf::read_within(gltf::Budget(memory), path, simdjson::SIMDJSON_PADDING);
        } catch (const FileError& error) {
            gltf::fail(file, "file", error.what());
        }
        return read_scene(gltf::Document(file, path.parent_path(), std::move(bytes), options, memory));
    });
}

} // namespace prelight
