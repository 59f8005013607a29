#pragma once
#include "option_table.hpp"

namespace prelight::app {

/// A completion script made of the table: `shell` is bash, zsh or fish. Throws UsageError for another.
std::string completion_script(const std::string& shell);

/// A manual page in the man macros: of the program, or of one of its commands ("" for the program). Throws UsageError
/// for a command that is not there.
std::string man_page(const std::string& command);

} // namespace prelight::app
