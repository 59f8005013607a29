#include "saved_bench.hpp"

#include <cmath>
#include <fmt/format.h>
#include <platform/read_file.hpp>
#include <prelight/error.hpp>

namespace prelight::app {
namespace {

using Json = nlohmann::ordered_json;

bool is_count(const Json& json) {
    return json.is_number_unsigned() || (json.is_number_integer() && json.get<int64_t>() >= 0);
}

/// An object of the file, with its place in it for messages. What is missing or of another kind is an
/// Error; nothing is guessed.
class Reader {
public:
    Reader(const Json& json, std::string place) : json_(json), place_(std::move(place)) {
        if (!json.is_object())
            throw Error(place_ + ": is no object");
    }

    const Json& at(const char* key) const {
        const auto found = json_.find(key);
        if (found == json_.end())
            throw Error(fmt::format("{}: {}: is missing", place_, key));
        return *found;
    }

    std::string text(const char* key) const {
        if (!at(key).is_string())
            refuse(key, "no text");
        return at(key).get<std::string>();
    }

    std::string text_or(const char* key, const std::string& other) const {
        const auto found = json_.find(key);
        return found == json_.end() || found->is_null() ? other : text(key);
    }

    uint64_t count(const char* key) const {
        if (!is_count(at(key)))
            refuse(key, "no whole number");
        return at(key).get<uint64_t>();
    }

    uint32_t small_count(const char* key) const {
        const uint64_t value = count(key);
        if (value > 0xffffffffu)
            refuse(key, "too large");
        return static_cast<uint32_t>(value);
    }

    double time(const char* key) const {
        if (!at(key).is_number() || !(at(key).get<double>() >= 0) || !std::isfinite(at(key).get<double>()))
            refuse(key, "no time");
        return at(key).get<double>();
    }

    Spread spread(const char* key) const {
        const Reader part = object(key);
        const Spread times{part.time("min"), part.time("median"), part.time("max")};
        if (times.min > times.median || times.median > times.max)
            refuse(key, "not in the order of min, median, max");
        return times;
    }

    const Json& json() const { return json_; }
    Reader object(const char* key) const { return {at(key), place_ + ": " + key}; }

    std::vector<Reader> list(const char* key) const {
        if (!at(key).is_array())
            refuse(key, "no list");
        std::vector<Reader> entries;
        for (const Json& entry : at(key))
            entries.emplace_back(entry, fmt::format("{}: {}[{}]", place_, key, entries.size()));
        return entries;
    }

    bool has(const char* key) const { return json_.contains(key) && !json_.at(key).is_null(); }

    [[noreturn]] void refuse(const char* key, const char* reason) const {
        throw Error(fmt::format("{}: {}: is {}", place_, key, reason));
    }

private:
    const Json& json_;
    std::string place_;
};

PassStats pass_of(const Reader& entry) {
    PassStats pass{.name = entry.text("name"), .gpu_ms = entry.spread("gpu_ms")};
    if (entry.has("cpu_ms"))
        pass.cpu_ms = entry.spread("cpu_ms");
    if (entry.has("bytes_read"))
        pass.bytes_read = entry.count("bytes_read");
    if (entry.has("bytes_written"))
        pass.bytes_written = entry.count("bytes_written");
    return pass;
}

void take_size(SavedRun& run, const Reader& entry) {
    const Json& size = entry.at("size");
    if (!size.is_array() || size.size() != 2 || !is_count(size[0]) || !is_count(size[1]))
        entry.refuse("size", "not width and height");
    run.width = size[0].get<uint32_t>();
    run.height = size[1].get<uint32_t>();
}

SavedRun run_of(const Reader& entry) {
    SavedRun run{.variant = entry.text_or("variant", ""),
                 .renderer = entry.text("renderer"),
                 .preset = entry.text_or("preset", ""),
                 .scene = entry.text("scene"),
                 .shading = entry.text_or("shading", "ggx"),
                 .device = entry.text_or("device", ""),
                 .driver = entry.text_or("driver", "")};
    const Json& settings = entry.object("settings").json();
    for (const auto& [key, value] : settings.items())
        if (value.is_string())
            run.settings[key] = value.get<std::string>();
    take_size(run, entry);
    run.msaa = entry.small_count("msaa");
    run.frames = entry.small_count("frames");
    run.lights = entry.count("lights");
    run.wall_ms = entry.spread("wall_ms");
    run.cpu_ms = entry.spread("cpu_ms");
    run.gpu_ms = entry.spread("gpu_ms");
    for (const Reader& pass : entry.list("passes"))
        run.passes.push_back(pass_of(pass));
    run.attachment_bytes = entry.count("attachment_bytes");
    run.device_bytes = entry.count("device_bytes");
    const Reader pairs = entry.object("light_pixel_pairs");
    run.pairs_evaluated = pairs.count("evaluated");
    run.pairs_contributing = pairs.count("contributing");
    return run;
}

/// F, and what the page draws.
void take_limit(SavedBench& bench, const Reader& limit) {
    for (const Reader& figures : limit.list("figures")) {
        figures.text("variant");
        figures.count("lights");
        figures.time("unit_ms");
        figures.time("frame_in_f");
        if (const std::string by = figures.text("frames_by"); by != "cpu_ms" && by != "gpu_ms")
            figures.refuse("frames_by", "no clock");
    }
    if (const Json& missing = limit.at("missing"); !missing.is_array())
        limit.refuse("missing", "no list");
    for (const Reader& entry : limit.list("runs")) {
        SavedRun run = run_of(entry);
        if (entry.text_or("role", "") != "plain-forward")
            continue;
        if (entry.has("at_lights")) // it has none itself
            run.lights = entry.count("at_lights");
        bench.units.push_back(std::move(run));
    }
}

/// For the page too.
void check_changes(const Reader& baseline) {
    baseline.text("file");
    for (const Reader& run : baseline.list("runs")) {
        run.text("variant");
        run.count("lights");
        for (const Reader& change : run.list("changes")) {
            change.text("figure");
            change.time("before");
            change.time("after");
            change.text("verdict");
        }
    }
}

} // namespace

SavedBench saved_bench(Json json, const std::string& name) {
    SavedBench bench{.runs = {}, .units = {}, .json = std::move(json)};
    const Reader file(bench.json, name);
    if (!file.has("runs"))
        throw Error(name + ": holds no figures of prelight bench SCENE (no \"runs\")");
    for (const Reader& entry : file.list("runs"))
        bench.runs.push_back(run_of(entry));
    if (bench.runs.empty())
        throw Error(name + ": runs: there is none");
    if (file.has("limit"))
        take_limit(bench, file.object("limit"));
    if (file.has("baseline"))
        check_changes(file.object("baseline"));
    return bench;
}

SavedBench load_bench(const std::filesystem::path& file) {
    Json json = Json::parse(read_file(file, largest_file::figures), nullptr, false);
    if (json.is_discarded())
        throw Error(file.string() + ": is not JSON");
    return saved_bench(std::move(json), file.string());
}

} // namespace prelight::app
