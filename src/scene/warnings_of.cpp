#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/error.hpp>
#include <prelight/scene.hpp>

namespace prelight {
namespace {

/// What a scene without triangles has instead: "2 nodes with a light, 1 node with a camera".
std::string contents_of(const Scene& scene) {
    size_t lights = 0, cameras = 0, meshes = 0, hidden = 0, empty = 0;
    for (const Node& node : scene.nodes) {
        const bool drawn = node.mesh && !scene.meshes[*node.mesh].primitives.empty();
        lights += node.light.has_value();
        cameras += node.camera.has_value();
        meshes += drawn;
        empty += node.mesh && !drawn;
        hidden += !node.visible;
    }
    std::vector<std::string> parts;
    const auto add = [&](size_t count, const char* what) {
        if (count > 0)
            parts.push_back(fmt::format("{} {} {}", count, count == 1 ? "node" : "nodes", what));
    };
    add(lights, "with a light");
    add(cameras, "with a camera");
    add(empty, "with a mesh of no triangles");
    add(meshes, "with a mesh that is hidden, flattened or in another scene");
    add(hidden, "hidden");
    if (parts.empty())
        return scene.nodes.empty() ? "the file has no nodes"
                                   : fmt::format("the file has {} empty nodes", scene.nodes.size());
    return fmt::format("the file has {}", fmt::join(parts, ", "));
}

} // namespace

std::vector<std::string> warnings_of(const World& world) {
    std::vector<std::string> out = world.scene->warnings;
    if (world.triangles == 0)
        out.push_back(escaped(fmt::format("{}: scene: no triangles, so the picture is empty; {}", world.scene->name,
                                          contents_of(*world.scene))));
    return out;
}

} // namespace prelight
