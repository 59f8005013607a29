#include <new>
#include <prelight/scene_io.hpp>
#include <scene/gltf/nodes.hpp>
#include <scene/gltf/primitives.hpp>
#include <scene/gltf/textures.hpp>

namespace prelight {
namespace {

/// In an order in which everything that an object names has been read before it.
Scene read_scene(const std::filesystem::path& path) {
    gltf::Document document(path);
    Scene scene;
    scene.name = document.file();
    gltf::Buffers buffers(document);
    gltf::Accessors accessors(document, buffers);
    gltf::Textures textures(document, buffers, scene);
    gltf::read_materials(document, textures, scene);
    gltf::read_meshes(document, buffers, accessors, scene);
    gltf::read_cameras(document, scene);
    gltf::read_lights(document, scene);
    gltf::read_nodes(document, accessors, scene);
    gltf::read_scenes(document, scene);
    if (!document.root().items("animations", "animation").empty())
        document.warn("skins, morph targets and animations are not evaluated", "animation 0");
    scene.warnings = document.warnings();
    return scene;
}

} // namespace

Scene load_gltf(const std::filesystem::path& path) {
    // What the limits let through may still be more than the machine has.
    try {
        return read_scene(path);
    } catch (const std::bad_alloc&) {
        gltf::fail(path.string(), "memory", "there is not enough to read the file");
    } catch (const std::length_error&) {
        gltf::fail(path.string(), "memory", "there is not enough to read the file");
    }
}

} // namespace prelight
