#include <prelight/error.hpp>
#include <prelight/scene.hpp>
#include <scene/find_by_name.hpp>

namespace prelight {

uint32_t find_animation(const Scene& scene, const std::string& name_or_index) {
    const auto name = [&](size_t i) -> const std::string& { return scene.animations[i].name; };
    const size_t count = scene.animations.size();
    if (const auto found = find_by_name(name_or_index, count, name))
        return static_cast<uint32_t>(*found);
    throw UsageError(fmt::format("--animation {}: no such animation; there is {}", name_or_index,
                                 count ? list_names(count, name) : "none"));
}

uint32_t find_scene(const Scene& scene, const std::string& name_or_index) {
    const auto name = [&](size_t i) -> const std::string& { return scene.scenes[i].name; };
    const size_t count = scene.scenes.size();
    if (const auto found = find_by_name(name_or_index, count, name))
        return static_cast<uint32_t>(*found);
    throw UsageError(fmt::format("--scene {}: no such scene; there is {}", name_or_index, list_names(count, name)));
}

} // namespace prelight
