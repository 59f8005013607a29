// Manual pages, made of the tables of commands and options.
#include "generated.hpp"
#include "help.hpp"
#include "suggestion.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <prelight/version.hpp>

namespace prelight::app {
namespace {

/// Text for roff: hyphens that are typed stay hyphens, and no line begins a request.
std::string roff(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (out.empty() && (c == '.' || c == '\''))
            out += "\\&";
        if (c == '-')
            out += "\\-";
        else if (c == '\\')
            out += "\\e";
        else
            out += c;
    }
    return out;
}

std::string tagged(std::string_view tag, std::string_view text) {
    return fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(tag), roff(text));
}

std::string paragraphs(std::string_view text) {
    std::string out;
    for (const std::string& paragraph : split_words(text, '\n'))
        out += ".PP\n" + roff(paragraph) + "\n";
    return out;
}

std::string man_head(std::string_view name, std::string_view summary) {
    std::string upper(name);
    std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return fmt::format(".TH {} 1 \"\" \"prelight {}\" \"Prelight\"\n.SH NAME\n{} \\- {}\n", roff(upper), version(),
                       roff(name), roff(summary));
}

std::string man_examples(std::string_view examples) {
    if (examples.empty())
        return {};
    std::string text = ".SH EXAMPLES\n.nf\n";
    for (const std::string& line : split_words(examples, '\n'))
        text += roff(line) + "\n";
    return text + ".fi\n";
}

std::string man_statuses() {
    std::string text = ".SH EXIT STATUS\n";
    for (const StatusRow& row : exit_statuses())
        text += tagged(row.status, row.text);
    return text;
}

std::string program_page() {
    std::string text = man_head("prelight", "render scenes with very many dynamic lights");
    text += ".SH SYNOPSIS\n\\fBprelight\\fR \\fICOMMAND\\fR ...\n.SH COMMANDS\n"
            "Each has a page of its own: \\fBprelight\\-render\\fR(1) and so on.\n";
    for (const CommandRow& command : command_table())
        if (!command.hidden)
            text += tagged(command.name, command.summary);
    text += ".SH OPTIONS\n" + tagged("-h, --help", "The commands; after a command: its options") +
            tagged("--version", "The version");
    text += ".SH ENVIRONMENT\n";
    for (const VariableRow& row : environment_variables())
        text += tagged(row.name, row.text);
    return text + man_statuses();
}

std::string command_page(const CommandRow& command) {
    std::string text = man_head("prelight-" + std::string(command.name), command.summary);
    text += fmt::format(".SH SYNOPSIS\n\\fBprelight {}\\fR", command.name);
    for (const PositionalRow& one : command.positionals)
        text += fmt::format(" {}\\fI{}\\fR{}", one.required ? "" : "[", roff(one.name),
                            one.required ? (one.repeatable ? " ..." : "") : (one.repeatable ? " ...]" : "]"));
    text += options_of(command).empty() ? "\n" : " [\\fIOPTIONS\\fR]\n";
    if (!command.positionals.empty() || !command.notes.empty())
        text += ".SH DESCRIPTION\n";
    for (const PositionalRow& one : command.positionals)
        text += tagged(one.name, one.help);
    text += paragraphs(command.notes);
    if (!options_of(command).empty())
        text += ".SH OPTIONS\n";
    for (const OptionGroup group : option_groups) {
        std::string options;
        for (const OptionRow* row : options_of(command))
            if (row->group == group)
                options += tagged(row->usage(), row->help);
        if (!options.empty())
            text += fmt::format(".SS {}\n{}", group_title(group), options);
    }
    return text + man_examples(command.examples) + man_statuses() + ".SH SEE ALSO\n\\fBprelight\\fR(1)\n";
}

} // namespace

std::string man_page(const std::string& name) {
    if (name.empty())
        return program_page();
    const CommandRow* command = find_command(name);
    if (!command || command->hidden)
        throw UsageError(fmt::format("{}: not a command{}", name, did_you_mean(name, command_names())));
    return command_page(*command);
}

} // namespace prelight::app
