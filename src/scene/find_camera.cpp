#include <prelight/error.hpp>
#include <prelight/scene.hpp>
#include <scene/find_by_name.hpp>

namespace prelight {

const PlacedCamera& find_camera(const World& world, const std::string& name_or_index) {
    const auto name = [&](size_t i) -> const std::string& { return world.cameras[i].camera.name; };
    if (const auto found = find_by_name(name_or_index, world.cameras.size(), name))
        return world.cameras[*found];
    throw UsageError(
        fmt::format("--camera {}: no such camera; there is {}", name_or_index, list_names(world.cameras.size(), name)));
}

} // namespace prelight
