// Completion for bash, zsh and fish, made of the table of options.
#include "generated.hpp"
#include "help.hpp"
#include "suggestion.hpp"

#include "../renderer_info.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>
#include <prelight/scene_io.hpp>
#include <set>
#include <setting_values/sample_counts.hpp>

namespace prelight::app {
namespace {

/// Of all renderers.
template <class Names>
std::vector<std::string> united(const Names& names_of) {
    std::set<std::string> all;
    for (const RendererInfo& info : renderer_infos())
        for (const std::string& name : names_of(info))
            all.insert(name);
    return {all.begin(), all.end()};
}

/// What is offered for a value; empty: nothing but files, or nothing at all.
std::vector<std::string> words_for(Takes takes, std::string_view words) {
    switch (takes) {
    case Takes::words: return split_words(words, ' ');
    case Takes::renderer: return renderer_names();
    case Takes::preset: return united([](const RendererInfo& info) { return info.presets; });
    case Takes::view: return united([](const RendererInfo& info) { return info.views; });
    case Takes::setting:
        return united([](const RendererInfo& info) {
            std::vector<std::string> keys;
            for (const SettingInfo& setting : info.settings)
                keys.push_back(setting.key + "=");
            return keys;
        });
    case Takes::samples: return sample_counts_above(0);
    case Takes::device: return {"auto", "cpu"};
    case Takes::environment: {
        std::vector<std::string> names{"none"};
        for (const BuiltinEnvironment& one : builtin_environments())
            names.emplace_back(one.name);
        return names;
    }
    case Takes::scene: {
        std::vector<std::string> names;
        for (const BuiltinScene& scene : builtin_scenes())
            names.emplace_back(scene.name);
        return names;
    }
    default: return {};
    }
}

bool takes_files(Takes takes) { return takes == Takes::file || takes == Takes::scene || takes == Takes::environment; }

/// Arguments without a name, of any place.
std::vector<std::string> positional_words(const CommandRow& command) {
    std::vector<std::string> words;
    for (const PositionalRow& one : command.positionals)
        for (std::string& word : words_for(one.takes, {}))
            words.push_back(std::move(word));
    if (command.bits == command_bit::bench)
        words.insert(words.end(), {"encodings", "light-buffers", "claims", "report"});
    if (command.bits == command_bit::help) {
        words = command_names();
        std::ranges::move(subject_names(), std::back_inserter(words));
    }
    return words;
}

bool positional_files(const CommandRow& command) {
    return std::ranges::any_of(command.positionals, [](const PositionalRow& one) { return takes_files(one.takes); });
}

/// One row a name.
std::vector<const OptionRow*> rows_once(const CommandRow& command) {
    std::vector<const OptionRow*> rows;
    for (const OptionRow* row : options_of(command))
        if (std::ranges::find(rows, row->names, &OptionRow::names) == rows.end())
            rows.push_back(row);
    return rows;
}

std::string bash_values(const OptionRow& row) {
    const std::vector<std::string> words = words_for(row.takes, row.words);
    std::string text;
    if (!words.empty())
        text += fmt::format("COMPREPLY=($(compgen -W '{}' -- \"$word\"));", fmt::join(words, " "));
    if (takes_files(row.takes))
        text += " compopt -o default;";
    if (row.takes == Takes::folder)
        text += " compopt -o dirnames;";
    if (row.takes == Takes::setting)
        text += " compopt -o nospace;";
    return text;
}

std::string bash_script() {
    std::string text = R"(# bash completion for prelight
_prelight() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]}
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then
)";
    text +=
        fmt::format("        COMPREPLY=($(compgen -W '{} --help --version' -- \"$word\"))\n        return\n    fi\n",
                    fmt::join(command_names(), " "));
    text += "    case $command in\n";
    for (const CommandRow& command : command_table()) {
        if (command.hidden)
            continue;
        text += fmt::format("    {})\n        case $before in\n", command.name);
        std::string options = "--help";
        for (const OptionRow* row : rows_once(command)) {
            options += " " + row->long_name();
            std::string names = row->short_name();
            if (names != row->long_name())
                names += "|" + row->long_name();
            if (!row->word.empty())
                text += fmt::format("        {}) {} return ;;\n", names, bash_values(*row));
        }
        text += "        esac\n";
        text += fmt::format("        if [[ $word == -* ]]; then\n"
                            "            COMPREPLY=($(compgen -W '{}' -- \"$word\"))\n        else\n"
                            "            COMPREPLY=($(compgen -W '{}' -- \"$word\"))\n{}        fi\n        ;;\n",
                            options, fmt::join(positional_words(command), " "),
                            positional_files(command) ? "            compopt -o default\n" : "");
    }
    return text + "    esac\n}\ncomplete -F _prelight prelight\n";
}

/// For zsh's _arguments, between single quotes: what has a meaning there is escaped.
std::string zsh_escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '\'')
            out += "'\\''";
        else if (c == '[' || c == ']' || c == ':' || c == '\\')
            out += std::string("\\") + c;
        else
            out += c;
    }
    return out;
}

/// What completes an argument. After a space _arguments calls it as it stands, else with options of its own, which
/// _alternative does not know; and colons end the action unless they are escaped.
std::string zsh_action(Takes takes, const std::vector<std::string>& words) {
    const std::string list = words.empty() ? "" : fmt::format("({})", fmt::join(words, " "));
    if (takes == Takes::folder)
        return "_files -/";
    if (!takes_files(takes))
        return list.empty() ? " " : list;
    return words.empty() ? "_files"
                         : fmt::format(" _alternative \"words\\:word\\:{}\" \"files\\:file\\:_files\"", list);
}

std::string zsh_script() {
    std::string text = "#compdef prelight\n# zsh completion for prelight\n_prelight() {\n    local -a commands\n"
                       "    commands=(\n";
    for (const CommandRow& command : command_table())
        if (!command.hidden)
            text += fmt::format("        '{}:{}'\n", command.name, zsh_escaped(command.summary));
    text += "    )\n    if (( CURRENT == 2 )); then\n        _describe command commands\n        return\n    fi\n"
            "    local command=${words[2]}\n    shift words\n    (( CURRENT-- ))\n    case $command in\n";
    for (const CommandRow& command : command_table()) {
        if (command.hidden)
            continue;
        text += fmt::format("    {})\n        _arguments \\\n            '(- *)'{{-h,--help}}'[its options]'",
                            command.name);
        for (const OptionRow* row : rows_once(command)) {
            const std::string once = row->repeatable ? "*" : "",
                              long_name = row->long_name() + (row->word.empty() ? "" : "=");
            std::string rest = fmt::format("[{}]", zsh_escaped(row->help));
            if (!row->word.empty()) {
                std::vector<std::string> words = words_for(row->takes, row->words);
                if (row->takes == Takes::setting) // its value is typed after the =
                    rest += fmt::format(":{}:({})", zsh_escaped(row->word), fmt::join(words, " "));
                else
                    rest += fmt::format(":{}:{}", zsh_escaped(row->word), zsh_action(row->takes, words));
            }
            text += row->short_name() == row->long_name()
                        ? fmt::format(" \\\n            '{}{}{}'", once, long_name, rest)
                        : fmt::format(" \\\n            '({0} {1})'{{{0},{2}}}'{3}'", row->short_name(),
                                      row->long_name(), long_name, rest);
        }
        if (!command.positionals.empty())
            text += fmt::format(
                " \\\n            '*:{}:{}'", zsh_escaped(command.positionals.front().name),
                zsh_action(positional_files(command) ? Takes::file : Takes::text, positional_words(command)));
        text += "\n        ;;\n";
    }
    return text + "    esac\n}\n_prelight \"$@\"\n";
}

std::string fish_quoted(std::string_view text) {
    std::string out = "'";
    for (const char c : text)
        out += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return out + "'";
}

std::string fish_script() {
    std::string text = "# fish completion for prelight\ncomplete -c prelight -f\n"
                       "complete -c prelight -n __fish_use_subcommand -s h -l help -d 'The commands'\n"
                       "complete -c prelight -n __fish_use_subcommand -l version -d 'The version'\n";
    for (const CommandRow& command : command_table())
        if (!command.hidden)
            text += fmt::format("complete -c prelight -n __fish_use_subcommand -a {} -d {}\n", command.name,
                                fish_quoted(command.summary));
    for (const CommandRow& command : command_table()) {
        if (command.hidden)
            continue;
        const std::string start = fmt::format("complete -c prelight -n '__fish_seen_subcommand_from {}'", command.name);
        text += start + " -s h -l help -d 'Its options'\n";
        if (const auto words = positional_words(command); !words.empty())
            text += fmt::format("{}{} -a {}\n", start, positional_files(command) ? " -F" : "",
                                fish_quoted(fmt::format("{}", fmt::join(words, " "))));
        for (const OptionRow* row : rows_once(command)) {
            text += start;
            if (row->short_name() != row->long_name())
                text += " -s " + row->short_name().substr(1);
            text += " -l " + row->long_name().substr(2);
            if (!row->word.empty()) {
                const auto words = words_for(row->takes, row->words);
                text += takes_files(row->takes) || row->takes == Takes::folder ? " -r -F" : " -x";
                if (!words.empty())
                    text += " -a " + fish_quoted(fmt::format("{}", fmt::join(words, " ")));
            }
            text += " -d " + fish_quoted(row->help) + "\n";
        }
    }
    return text;
}

} // namespace

std::string completion_script(const std::string& shell) {
    if (shell == "bash")
        return bash_script();
    if (shell == "zsh")
        return zsh_script();
    if (shell == "fish")
        return fish_script();
    throw UsageError(
        fmt::format("{}: no shell (bash, zsh, fish){}", shell, did_you_mean(shell, {"bash", "zsh", "fish"})));
}

} // namespace prelight::app
