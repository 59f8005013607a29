#pragma once
#include <cstdint>
#include <filesystem>
#include <prelight/export.hpp>
#include <prelight/scene.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace prelight {

/// How load_gltf() reads.
struct LoadOptions {
    bool strict = false; ///< what would be a warning about the file is an Error with the same line
    /// Bytes that reading may plan with: a quarter for the pictures as they are when decoded (textures that do not fit
    /// are scaled down, with a warning), a quarter for geometry. 0: what the machine can spare now.
    uint64_t memory_limit = 0;
};

/// Reads glTF 2.0, .gltf or .glb (told apart by content). Everything is checked before it is used. What is wrong
/// with one object alone is repaired or leaves that object out; Scene::warnings says so. What makes the file
/// unusable (its JSON, its indices, its buffers) throws Error with one line "FILE: OBJECT: REASON".
/// Memory stays below the limits that `docs/gltf.md` states.
PRELIGHT_API Scene load_gltf(const std::filesystem::path& path, const LoadOptions& options = {});

/// Writes the scene as .glb (images as PNG) that the Khronos validator accepts without errors.
/// The file appears under a temporary name and is renamed when whole. Throws Error.
PRELIGHT_API void save_glb(const Scene& scene, const std::filesystem::path& path);

/// Reads a picture of all directions: Radiance .hdr, OpenEXR or (sRGB-encoded, 8 bits) PNG, told apart by the name's
/// ending. Throws Error "FILE: REASON": not twice as wide as high, wider than 16,384, a value negative or not finite.
PRELIGHT_API Environment load_environment(const std::filesystem::path& path);

/// What there is to know of a built-in environment.
struct BuiltinEnvironment {
    std::string_view name;        ///< as make_environment() takes it
    std::string_view description; ///< one line
};
/// All of them: studio.
PRELIGHT_API std::vector<BuiltinEnvironment> builtin_environments();

/// A built-in environment, with soft_backdrop() behind it; the same name gives the same map. Throws UsageError for an
/// unknown one.
PRELIGHT_API Environment make_environment(std::string_view name);

/// A backdrop that does not compete with what stands before it: grey, lighter around the horizon. For
/// Environment::backdrop.
PRELIGHT_API Image soft_backdrop();

/// What there is to know of a built-in scene.
struct BuiltinScene {
    std::string_view name;        ///< as make_scene() takes it
    std::string_view description; ///< one line
    uint32_t default_lights;      ///< how many lights it is meant to have, 1 … 65,536
};
/// All of them: city, spheres, lights, motion …
PRELIGHT_API std::vector<BuiltinScene> builtin_scenes();

/// Makes a procedural scene; the same name, count and seed give the same bytes everywhere.
/// `lights`: 1 … 65,536. Throws UsageError for an unknown name or a count out of range.
PRELIGHT_API Scene make_scene(std::string_view name, uint32_t lights, uint64_t seed);

} // namespace prelight
