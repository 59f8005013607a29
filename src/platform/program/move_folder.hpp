#pragma once
#include <filesystem>
#include <system_error>

namespace prelight {

/// Gives `from` the name `to`. Where there is a folder `to`, both swap their names: at once where the file system can,
/// else by way of a third name. Returns what failed, and then all names are as they were; no error where it succeeded.
std::error_code move_folder(const std::filesystem::path& from, const std::filesystem::path& to);

} // namespace prelight
