#include "job.hpp"

#include "options/suggestion.hpp"
#include "renderer_info.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight::app {
namespace {

constexpr std::array tile_sizes{4u, 8u, 16u, 32u};

const SettingInfo* find_setting(const RendererInfo& info, std::string_view key) {
    const auto found = std::ranges::find(info.settings, key, &SettingInfo::key);
    return found == info.settings.end() ? nullptr : &*found;
}

bool has_value(const RendererInfo& info, std::string_view key, std::string_view value) {
    const SettingInfo* setting = find_setting(info, key);
    return setting && std::ranges::find(setting->values, value) != setting->values.end();
}

Job make_job(Variant variant, Role role, const BenchCommand& command) {
    Job job{.variant = std::move(variant), .role = role, .options = command.options};
    job.options.preset = job.variant.preset;
    job.options.settings = job.variant.settings;
    return job;
}

/// The contender's light pass over lists of another making, in tiles of `size` pixels.
Variant with_lists(Variant variant, const char* lists, uint32_t size) {
    // What only another way of finding lights obeys is refused with this one.
    for (const SettingInfo& setting : find_renderer(variant.renderer).settings)
        for (const SettingNeed& need : setting.needs)
            if (need.key == "light-culling" && std::ranges::find(need.values, "tiles") == need.values.end())
                variant.settings.erase(setting.key);
    variant.settings["light-lists"] = lists;
    variant.settings["light-culling"] = "tiles";
    variant.settings["tile-size"] = std::to_string(size);
    return variant;
}

void add_once(std::vector<Job>& jobs, Job job) {
    if (std::ranges::find(jobs, job) == jobs.end())
        jobs.push_back(std::move(job));
}

void add_lists(std::vector<Job>& jobs, const Job& contender, const BenchCommand& command) {
    const RendererInfo info = find_renderer(contender.variant.renderer);
    for (const auto& [role, lists] : {std::pair(Role::perfect, "perfect"), std::pair(Role::empty, "empty")})
        for (const uint32_t size : tile_sizes)
            if (has_value(info, "light-lists", lists) && has_value(info, "tile-size", std::to_string(size))) {
                Job job = make_job(with_lists(contender.variant, lists, size), role, command);
                job.tile = size;
                add_once(jobs, std::move(job));
            }
}

} // namespace

const char* role_name(Role role) {
    switch (role) {
    case Role::unit: return "plain-forward";
    case Role::perfect: return "perfect-lists";
    case Role::empty: return "empty-lists";
    case Role::no_lights: return "no-lights";
    default: return "contender";
    }
}

std::string Job::name() const {
    switch (role) {
    case Role::unit: return "F: plain forward";
    case Role::perfect: return fmt::format("{}, perfect lists, tiles of {}", variant.renderer, tile);
    case Role::empty: return fmt::format("{}, empty lists, tiles of {}", variant.renderer, tile);
    case Role::no_lights: return variant.name() + ", no lights";
    default: return variant.name();
    }
}

std::vector<Job> contenders_of(const BenchCommand& command) {
    std::vector<Variant> variants = command.variants;
    if (variants.empty())
        variants = {{.renderer = "light-prepass"}, {.renderer = "deferred"}};
    std::vector<Job> jobs;
    std::map<std::string, std::string> unused = command.options.settings;
    std::vector<std::string> keys;
    for (Variant& variant : variants) {
        const RendererInfo info = find_renderer(variant.renderer);
        if (!info.needs_device)
            throw UsageError(fmt::format("--renderers {}: is not timed, it is what pictures are judged by", info.name));
        for (std::string& key : keys_of(info))
            keys.push_back(std::move(key));
        for (const auto& [key, value] : command.options.settings)
            if (find_setting(info, key)) {
                variant.settings.emplace(key, value);
                unused.erase(key);
            }
        add_once(jobs, make_job(variant, Role::contender, command));
    }
    if (!unused.empty())
        throw UsageError(fmt::format("--set {}={}: no renderer of --renderers has that setting{}",
                                     unused.begin()->first, unused.begin()->second,
                                     did_you_mean(unused.begin()->first, keys)));
    return jobs;
}

std::vector<Job> limit_jobs(const std::vector<Job>& contenders, const BenchCommand& command,
                            std::vector<std::string>& missing) {
    std::vector<Job> jobs;
    Variant unit{.renderer = "plain-forward"};
    if (const auto filter = command.options.settings.find("texture-filter"); filter != command.options.settings.end())
        unit.settings.insert(*filter); // the same textures, read the same way
    jobs.push_back(make_job(unit, Role::unit, command));
    for (const Job& contender : contenders) {
        add_once(jobs, make_job(contender.variant, Role::no_lights, command));
        const size_t before = jobs.size();
        add_lists(jobs, contender, command);
        if (jobs.size() == before && jobs_for(contender, Role::perfect, jobs).empty()) {
            const std::string line = fmt::format("{}: no limit of its light pass: it has no setting light-lists",
                                                 contender.variant.renderer);
            if (std::ranges::find(missing, line) == missing.end())
                missing.push_back(line);
        }
    }
    return jobs;
}

std::vector<const Job*> jobs_for(const Job& contender, Role role, const std::vector<Job>& jobs) {
    std::vector<const Job*> found;
    for (const Job& job : jobs) {
        const char* lists = role == Role::perfect ? "perfect" : "empty";
        const bool own = role == Role::unit        ? true
                         : role == Role::no_lights ? job.variant == contender.variant
                                                   : job.variant == with_lists(contender.variant, lists, job.tile);
        if (job.role == role && own)
            found.push_back(&job);
    }
    return found;
}

} // namespace prelight::app
