#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace prelight::app {

/// The files that a glTF scene names (buffers, pictures, light profiles) and that are there; its text is looked
/// through and not checked. Nothing for a built-in scene, or for a file that is no glTF.
std::vector<std::filesystem::path> files_named_in(const std::string& scene);

/// The JSON of a glTF file, as text: of a .glb its first chunk. Not checked; empty where there is none.
std::string json_of(const std::filesystem::path& file);

} // namespace prelight::app
