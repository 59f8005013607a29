#include "baseline.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace prelight::app {
namespace {

using Json = nlohmann::ordered_json;

/// A built-in scene's name, or the name of a file wherever it lies.
std::string scene_name(const std::string& scene) { return std::filesystem::path(scene).filename().string(); }

bool settings_agree(const SavedRun& a, const SavedRun& b) {
    return std::ranges::all_of(a.settings, [&](const auto& setting) {
        const auto other = b.settings.find(setting.first);
        return other == b.settings.end() || other->second == setting.second;
    });
}

bool same_place(const SavedRun& a, const SavedRun& b) {
    return scene_name(a.scene) == scene_name(b.scene) && a.width == b.width && a.height == b.height &&
           a.msaa == b.msaa && a.shading == b.shading && a.lights == b.lights;
}

const SavedRun* find_unit(const std::vector<SavedRun>& units, const SavedRun& run) {
    const auto found = std::ranges::find_if(units, [&](const SavedRun& unit) { return same_place(unit, run); });
    return found == units.end() ? nullptr : &*found;
}

const char* verdict_text(const Change& change) {
    if (!change.counted)
        return judgement_name(change.verdict).data();
    return change.before == change.after ? "the same" : "changed";
}

/// Settings that both have and that differ, "key: before → after".
std::vector<std::string> other_settings(const SavedRun& before, const SavedRun& after) {
    std::vector<std::string> lines;
    for (const auto& [key, value] : before.settings)
        if (const auto now = after.settings.find(key); now != after.settings.end() && now->second != value)
            lines.push_back(fmt::format("{}: {} → {}", key, value, now->second));
    return lines;
}

std::string title(const SavedRun& run) {
    return fmt::format("{}, {} light{}", run.variant.empty() ? run.renderer : run.variant, run.lights,
                       run.lights == 1 ? "" : "s");
}

bool same_device(const SavedRun& a, const SavedRun& b) { return a.device == b.device && a.driver == b.driver; }

void add_times(std::vector<Change>& changes, const SavedRun& before, const SavedRun* unit_before, const SavedRun& after,
               const SavedRun* unit_after) {
    const auto judged = [&](const Figure& a, const Figure& b) { return judge(a, b, before.frames, after.frames); };
    bool unit_changed = false;
    if (unit_before && unit_after && unit_before->cpu_ms.median > 0 && unit_after->cpu_ms.median > 0) {
        const Figure f_before = figure_of(unit_before->cpu_ms), f_after = figure_of(unit_after->cpu_ms);
        const Figure a = figure_of(before.cpu_ms) / f_before, b = figure_of(after.cpu_ms) / f_after;
        changes.push_back({"CPU, in F", a.value, b.value, false, judged(a, b)});
        changes.push_back({"F, CPU ms", f_before.value, f_after.value, false, judged(f_before, f_after)});
        unit_changed = changes.back().verdict == Judgement::beyond;
    }
    const auto add = [&](std::string name, const Figure& a, const Figure& b) {
        const Judgement judgement = judged(a, b);
        changes.push_back({std::move(name), a.value, b.value, false,
                           judgement == Judgement::beyond && unit_changed ? Judgement::unit_changed : judgement});
    };
    add("CPU ms", figure_of(before.cpu_ms), figure_of(after.cpu_ms));
    add("wall ms", figure_of(before.wall_ms), figure_of(after.wall_ms));
    add("device ms", figure_of(before.gpu_ms), figure_of(after.gpu_ms));
    for (const PassStats& pass : after.passes) {
        const auto old = std::ranges::find(before.passes, pass.name, &PassStats::name);
        if (old == before.passes.end())
            continue;
        const bool cpu = pass.cpu_ms && old->cpu_ms;
        add(fmt::format("{}, {} ms", pass.name, cpu ? "CPU" : "device"), figure_of(cpu ? *old->cpu_ms : old->gpu_ms),
            figure_of(cpu ? *pass.cpu_ms : pass.gpu_ms));
    }
}

Json change_json(const Change& change) {
    return {{"figure", change.figure},
            {"before", change.before},
            {"after", change.after},
            {"verdict", verdict_text(change)}};
}

} // namespace

std::string Change::difference() const {
    if (before == after)
        return "0 %";
    return before > 0 ? fmt::format("{:+.1f} %", 100 * (after - before) / before) : "new";
}

bool same_work(const SavedRun& a, const SavedRun& b) {
    if (!same_place(a, b) || a.renderer != b.renderer || a.preset != b.preset)
        return false;
    return a.variant.empty() || b.variant.empty() ? settings_agree(a, b) : a.variant == b.variant;
}

std::vector<Change> changes_of(const SavedRun& before, const SavedRun* unit_before, const SavedRun& after,
                               const SavedRun* unit_after) {
    std::vector<Change> changes;
    const auto count = [&](std::string name, uint64_t a, uint64_t b) {
        changes.push_back({std::move(name), double(a), double(b), true, Judgement::within});
    };
    if (same_device(before, after))
        add_times(changes, before, unit_before, after, unit_after);
    count("pairs evaluated", before.pairs_evaluated, after.pairs_evaluated);
    count("pairs contributing", before.pairs_contributing, after.pairs_contributing);
    count("attachment bytes", before.attachment_bytes, after.attachment_bytes);
    count("device bytes", before.device_bytes, after.device_bytes);
    return changes;
}

Json print_changes(const SavedBench& before, const SavedBench& after, const std::string& file) {
    Json json = {{"file", file}, {"runs", Json::array()}};
    fmt::print("\nagainst {}\n", file);
    for (const SavedRun& run : after.runs) {
        const auto old = std::ranges::find_if(before.runs, [&](const SavedRun& one) { return same_work(one, run); });
        if (old == before.runs.end()) {
            fmt::print("{}: not in it\n", title(run));
            continue;
        }
        fmt::print("{}{}\n", title(run),
                   same_device(*old, run) ? "" : fmt::format(" (there on {}: only counts compare)", old->device));
        Json entry = {{"variant", run.variant},
                      {"lights", run.lights},
                      {"same_device", same_device(*old, run)},
                      {"changes", Json::array()}};
        const auto settings = other_settings(*old, run);
        for (const std::string& line : settings)
            fmt::print("    {}\n", line);
        entry["settings_changed"] = settings;
        for (const Change& change : changes_of(*old, find_unit(before.units, run), run, find_unit(after.units, run))) {
            const int digits = change.counted ? 0 : change.after >= 100 ? 1 : change.after >= 10 ? 2 : 3;
            fmt::print("    {:<36} {:>13.{}f} → {:>13.{}f}  {:>10}  {}\n", change.figure, change.before, digits,
                       change.after, digits, change.difference(), verdict_text(change));
            entry["changes"].push_back(change_json(change));
        }
        json["runs"].push_back(std::move(entry));
    }
    return json;
}

} // namespace prelight::app
