#include <charconv>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <prelight/scene.hpp>

namespace prelight {

const PlacedCamera& find_camera(const World& world, const std::string& name_or_index) {
    for (const PlacedCamera& placed : world.cameras)
        if (!placed.camera.name.empty() && placed.camera.name == name_or_index)
            return placed;
    size_t index = 0;
    const char* end = name_or_index.data() + name_or_index.size();
    const auto [last, error] = std::from_chars(name_or_index.data(), end, index);
    if (error == std::errc() && last == end && index < world.cameras.size())
        return world.cameras[index];
    std::string known;
    for (size_t i = 0; i < world.cameras.size(); ++i)
        known += fmt::format("{}{} \"{}\"", i ? ", " : "", i, world.cameras[i].camera.name);
    throw UsageError(fmt::format("--camera {}: no such camera; there is {}", name_or_index, known));
}

} // namespace prelight
