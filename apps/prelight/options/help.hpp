#pragma once
#include "option_table.hpp"

#include <cstdio>

namespace prelight::app {

/// Breaks a text at spaces into lines of at most `width` characters; a word that is longer stands alone. Its own line
/// ends stay.
std::vector<std::string> wrapped(std::string_view text, size_t width);

/// "  NAME      text", the text wrapped in a column of its own.
std::string two_columns(std::string_view name, std::string_view text, size_t width);

/// `prelight --help`: the commands. Headings are styled for standard output.
std::string program_help();
/// `prelight COMMAND --help`: its options, by groups.
std::string command_help(const CommandRow& command);
/// `prelight help TOPIC`: a command, an option, a renderer, a setting, or a subject. Empty: the topics that there are.
/// Throws UsageError for another.
std::string topic_help(const std::string& topic);

/// The subjects among the topics, as one word each: "exit-status".
std::vector<std::string> subject_names();

/// An environment variable that the program reads.
struct VariableRow {
    std::string_view name, text;
};
std::span<const VariableRow> environment_variables();

/// What an exit status means.
struct StatusRow {
    std::string_view status, text;
};
std::span<const StatusRow> exit_statuses();

} // namespace prelight::app
