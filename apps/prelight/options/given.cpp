// The only unit that includes CLI11: it takes seconds to compile.
#include "given.hpp"

#include "suggestion.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight::app {
namespace {

std::string see_help(const CommandRow& command) { return fmt::format(" (see prelight {} --help)", command.name); }

/// What of the command line belongs to nothing: options before words, since a word may be an unknown option's value.
void check_rest(const CommandRow& command, const std::vector<std::string>& rest) {
    std::vector<std::string> known{"--help"};
    std::string unknown;
    for (const OptionRow* row : options_of(command))
        known.push_back(row->long_name());
    for (const std::string& word : rest)
        if (word.size() > 1 && word[0] == '-') {
            const std::string name = word.substr(0, word.find('='));
            unknown += unknown.empty() ? "" : unknown.back() == '?' ? " " : "; ";
            unknown += fmt::format("{}: not an option of {}{}", name, command.name, did_you_mean(name, known));
        }
    if (!unknown.empty())
        throw UsageError(unknown + see_help(command));
    if (!rest.empty())
        throw UsageError(fmt::format(
            "{}: not expected: {} takes {}{}", rest.front(), command.name,
            command.positionals.empty() ? "no argument" : fmt::format("one {}", command.positionals.front().name),
            see_help(command)));
}

} // namespace

bool Given::has(std::string_view name) const { return !all(name).empty(); }

std::string Given::text(std::string_view name, std::string_view otherwise) const {
    const std::vector<std::string>& values = all(name);
    return values.empty() ? std::string(otherwise) : values.back();
}

const std::vector<std::string>& Given::all(std::string_view name) const {
    static const std::vector<std::string> none;
    const auto found = values_.find(name);
    return found == values_.end() ? none : found->second;
}

void Given::check_bit(uint32_t bit, const std::map<uint32_t, std::string>& meaning) const {
    for (const auto& [name, values] : values_) {
        uint32_t bits = 0;
        std::string as_typed;
        for (const OptionRow* row : options_of(*command_))
            if (row->long_name() == name) {
                bits |= row->commands & command_->bits;
                as_typed = row->short_name();
            }
        if (!values.empty() && bits != 0 && !(bits & bit))
            throw UsageError(fmt::format("{}: goes with {} only", as_typed, meaning.at(bits)));
    }
}

std::optional<Given> parse_arguments(const CommandRow& command, const std::vector<std::string>& arguments) {
    CLI::App app;
    app.allow_extras();
    Given given(command);
    std::map<std::string, int64_t> flags;
    for (const PositionalRow& positional : command.positionals) {
        auto& values = given.values_[std::string(positional.name)];
        app.add_option(std::string(positional.name), values)
            ->expected(1, positional.repeatable ? CLI::detail::expected_max_vector_size : 1)
            ->allow_extra_args(positional.repeatable);
    }
    for (const OptionRow* row : options_of(command)) {
        const std::string name = row->long_name();
        const bool again = given.values_.contains(name) || flags.contains(name);
        if (again) // means something else with another kind of the command
            continue;
        if (row->word.empty())
            app.add_flag(std::string(row->names), flags[name]);
        else
            app.add_option(std::string(row->names), given.values_[name])
                ->type_name(std::string(row->word))
                ->allow_extra_args(false);
    }
    try {
        // CLI11 takes them from the end.
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::CallForHelp&) {
        return {};
    } catch (const CLI::ParseError& error) {
        check_rest(command, app.remaining()); // what was typed before
        throw UsageError(std::string(error.what()) + see_help(command));
    }
    check_rest(command, app.remaining());
    for (const auto& [name, count] : flags)
        if (count > 0)
            given.values_[name] = {"on"};
    for (const PositionalRow& positional : command.positionals)
        if (positional.required && !given.has(positional.name))
            throw UsageError(fmt::format("{} is required: {}{}", positional.name, positional.help, see_help(command)));
    for (const OptionRow* row : options_of(command)) {
        const std::vector<std::string>& values = given.all(row->long_name());
        if (row->required && values.empty())
            throw UsageError(fmt::format("{} is required{}", row->long_name(), see_help(command)));
        if (!row->repeatable && values.size() > 1)
            throw UsageError(fmt::format("{}: given twice, as {} and {}", row->short_name(), values[0], values[1]));
    }
    return given;
}

} // namespace prelight::app
