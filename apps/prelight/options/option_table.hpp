#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace prelight::app {

/// Commands as bits, for the rows of the table. `bench` is three: what goes with a scene to time, with a table of its
/// own, and with a report.
namespace command_bit {
constexpr uint32_t render = 1, sequence = 2, view = 4, compare = 8, bench_scene = 16, bench_table = 32,
                   bench_report = 64, make = 128, info = 256, devices = 512, renderers = 1024, materials = 2048,
                   help = 4096, completions = 8192, man = 16384;
constexpr uint32_t bench = bench_scene | bench_table | bench_report;
constexpr uint32_t figures = bench_scene | bench_table; ///< what of `bench` measures
} // namespace command_bit

/// Under which heading help shows an option.
enum class OptionGroup { scene, picture, renderer, frames, output, device, diagnostics };
constexpr OptionGroup option_groups[]{OptionGroup::scene,      OptionGroup::picture, OptionGroup::renderer,
                                      OptionGroup::frames,     OptionGroup::output,  OptionGroup::device,
                                      OptionGroup::diagnostics};
std::string_view group_title(OptionGroup group);

/// What the value of an option is, for completion.
enum class Takes { text, file, folder, scene, renderer, preset, setting, view, device, environment, samples, words };

/// An option, for the commands that it means the same to: what parsing, help, the man pages and completion know of it.
struct OptionRow {
    std::string_view names; ///< "-o,--output" or "--size"
    std::string_view word;  ///< what stands for the value in help; empty: a flag
    OptionGroup group = OptionGroup::scene;
    uint32_t commands = 0;
    std::string_view help;
    Takes takes = Takes::text;
    std::string_view words = {}; ///< of Takes::words, separated by spaces
    bool repeatable = false;
    bool required = false;

    /// "-o" of "-o,--output": how a message names it.
    std::string short_name() const;
    /// "--output": how Given knows it.
    std::string long_name() const;
    /// "-o, --output FOLDER".
    std::string usage() const;
};

/// An argument without a name.
struct PositionalRow {
    std::string_view name;
    std::string_view help;
    Takes takes = Takes::text;
    bool required = true;
    bool repeatable = false;
};

struct CommandRow {
    std::string_view name;
    uint32_t bits = 0;
    std::string_view summary; ///< one line
    std::vector<PositionalRow> positionals = {};
    std::string_view notes = {};    ///< below the options; may be empty
    std::string_view examples = {}; ///< command lines, one each
    bool hidden = false;            ///< in no list: for those who build packages
};

std::span<const OptionRow> option_table();
const std::vector<CommandRow>& command_table();

/// The options of one command, in the table's order.
std::vector<const OptionRow*> options_of(const CommandRow& command);
/// Null: there is none.
const CommandRow* find_command(std::string_view name);
/// The names of commands that are not hidden.
std::vector<std::string> command_names();

/// The parts of "a|b" between its separators; none is empty.
std::vector<std::string> split_words(std::string_view text, char separator);

} // namespace prelight::app
