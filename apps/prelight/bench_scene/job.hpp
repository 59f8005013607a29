#pragma once
#include "command_line.hpp"

#include <prelight/renderer.hpp>

namespace prelight::app {

/// What a job is measured for.
enum class Role {
    contender, ///< what the user asked for
    unit,      ///< F: one plain forward pass without lights
    perfect,   ///< the light pass with lists that hold only what contributes
    empty,     ///< the light pass with empty lists
    no_lights, ///< a contender without any light: geometry, and what a light pass costs by being there
};
/// As JSON has it: "contender", "plain-forward", "perfect-lists", "empty-lists", "no-lights".
const char* role_name(Role role);

/// One way to render that `bench SCENE` measures.
struct Job {
    Variant variant; ///< with the settings of --set
    Role role = Role::contender;
    uint32_t tile = 0; ///< of perfect and empty lists: pixels
    RenderOptions options;

    /// As its column is headed: the variant's name, or what it is.
    std::string name() const;
    bool operator==(const Job& other) const { return role == other.role && variant == other.variant; }
};

/// What --renderers names, or light-prepass and deferred; each with those settings of --set that it has
/// and does not set itself. Throws UsageError for a setting that none of them has.
std::vector<Job> contenders_of(const BenchCommand& command);

/// What --limit adds for these contenders. `missing` gets a line for what cannot be measured.
std::vector<Job> limit_jobs(const std::vector<Job>& contenders, const BenchCommand& command,
                            std::vector<std::string>& missing);
/// The limit job of that role that belongs to a contender: its own settings but for how lights find their
/// pixels. Several for lists, one a tile size.
std::vector<const Job*> jobs_for(const Job& contender, Role role, const std::vector<Job>& jobs);

} // namespace prelight::app
