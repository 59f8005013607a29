#include "help.hpp"

#include "../terminal.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <platform/program/terminal.hpp>

namespace prelight::app {
namespace {

constexpr size_t name_column = 30;

size_t page_width() { return std::clamp<size_t>(columns_of(stdout), 60, 100); }

std::string heading(std::string_view text) { return "\n" + styled(stdout, Style::heading, text) + "\n"; }

std::string usage_of(const CommandRow& command) {
    std::string text = "prelight " + std::string(command.name);
    for (const PositionalRow& one : command.positionals)
        text += fmt::format(" {}{}{}{}", one.required ? "" : "[", one.name, one.repeatable ? "..." : "",
                            one.required ? "" : "]");
    for (const OptionRow* row : options_of(command))
        if (row->required)
            text += fmt::format(" {} {}", row->short_name(), row->word);
    return options_of(command).empty() ? text : text + " [OPTIONS]";
}

std::string examples_of(std::string_view examples) {
    std::string text = heading("Examples:");
    for (const std::string& line : split_words(examples, '\n'))
        text += "  " + line + "\n";
    return text;
}

} // namespace

std::vector<std::string> wrapped(std::string_view text, size_t width) {
    std::vector<std::string> lines;
    for (const std::string& paragraph : split_words(text, '\n')) {
        lines.emplace_back();
        for (const std::string& word : split_words(paragraph, ' ')) {
            if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width)
                lines.emplace_back();
            lines.back() += (lines.back().empty() ? "" : " ") + word;
        }
    }
    return lines;
}

std::string two_columns(std::string_view name, std::string_view text, size_t width) {
    std::string out = fmt::format("  {}", name);
    if (out.size() + 2 > name_column)
        out += "\n";
    bool first = out.back() != '\n';
    for (const std::string& line : wrapped(text, width - name_column)) {
        out += std::string(first ? name_column - out.size() : name_column, ' ') + line + "\n";
        first = false;
    }
    return out.back() == '\n' ? out : out + "\n";
}

std::string program_help() {
    const size_t width = page_width();
    std::string text = "Prelight renders scenes with very many dynamic lights.\n";
    text += heading("Usage:") + "  prelight COMMAND ...\n" + heading("Commands:");
    for (const CommandRow& command : command_table())
        if (!command.hidden)
            text += two_columns(command.name, command.summary, width);
    text += heading("Options:") + two_columns("-h, --help", "This text; after a command: its options", width) +
            two_columns("--version", "The version", width);
    text += examples_of(R"(prelight render city --lights 1024 -o night.png
prelight render helmet.glb --camera 1 --size 1920x1080 -o helmet.exr
prelight sequence fox.glb -o fox.####.png
prelight view city
prelight compare city -o report
prelight make spheres -o spheres.glb
prelight renderers light-prepass
prelight bench city --light-counts 64,1024 --limit --json city.json)");
    text += heading("Exit status:");
    for (const StatusRow& row : exit_statuses())
        text += two_columns(row.status, row.text, width);
    return text + "\n`prelight help` lists topics: settings, scenes, environment variables and more.\n";
}

std::string command_help(const CommandRow& command) {
    const size_t width = page_width();
    std::string text = std::string(command.summary) + "\n" + heading("Usage:") + "  " + usage_of(command) + "\n";
    if (!command.positionals.empty())
        text += heading("Arguments:");
    for (const PositionalRow& one : command.positionals)
        text += two_columns(one.name, one.help, width);
    for (const OptionGroup group : option_groups) {
        std::string options;
        for (const OptionRow* row : options_of(command))
            if (row->group == group)
                options += two_columns(row->usage(), row->help, width);
        if (!options.empty())
            text += heading(std::string(group_title(group)) + ":") + options;
    }
    text += heading("Help:") + two_columns("-h, --help", "This text", width);
    if (!command.notes.empty())
        text += "\n";
    for (const std::string& line : wrapped(command.notes, width))
        text += line + "\n";
    return command.examples.empty() ? text : text + examples_of(command.examples);
}

} // namespace prelight::app
