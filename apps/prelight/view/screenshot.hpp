#pragma once
#include <filesystem>
#include <prelight/image.hpp>
#include <string>

namespace prelight::app::viewer {

/// Writes the picture to `name`, which has to end in .png; an empty one becomes prelight-N.png, the next that is free.
/// The file that was written. Throws Error.
std::filesystem::path save_screenshot(const Image& picture, const std::string& name);

} // namespace prelight::app::viewer
