#pragma once
#include <filesystem>
#include <string>

namespace prelight {

/// The number that no other process of this system has meanwhile.
int process_id();

/// The file of the program that runs; empty when it cannot be told.
std::filesystem::path program_file();
/// Text that is another one for every other file or build of the program; "?" when it cannot be told.
std::string program_identity();

/// What programs and libraries that this process loads will find under `name`, unless it is there already. Not while
/// other threads read the environment.
void set_environment_default(const char* name, const std::string& value);

/// Where the programs of this user keep what they can make again: $XDG_CACHE_HOME, or ~/.cache. Empty when neither can
/// be told.
std::filesystem::path user_cache_folder();

} // namespace prelight
