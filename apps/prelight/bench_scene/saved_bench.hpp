#pragma once
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <prelight/renderer.hpp>
#include <string>
#include <vector>

namespace prelight::app {

/// A run of a saved file, as far as runs are compared.
struct SavedRun {
    std::string variant; ///< empty: the file does not say what was asked for
    std::string renderer, preset, scene, shading, device, driver;
    std::map<std::string, std::string> settings; ///< in force
    uint32_t width = 0, height = 0, msaa = 1, frames = 0;
    uint64_t lights = 0;
    Spread wall_ms, cpu_ms, gpu_ms;
    std::vector<PassStats> passes;
    uint64_t attachment_bytes = 0, device_bytes = 0;
    uint64_t pairs_evaluated = 0, pairs_contributing = 0;
};

/// A file of `bench SCENE`.
struct SavedBench {
    std::vector<SavedRun> runs;
    std::vector<SavedRun> units; ///< F by number of lights, when --limit measured it
    nlohmann::ordered_json json; ///< all of it
};

/// Takes the figures out of JSON. Throws Error "NAME: what is not as it should be".
SavedBench saved_bench(nlohmann::ordered_json json, const std::string& name);
/// Throws Error naming the file: it cannot be read, is no JSON, or holds no figures of `bench SCENE`.
SavedBench load_bench(const std::filesystem::path& file);

} // namespace prelight::app
