#pragma once
#include "drawer.hpp"

#include <filesystem>
#include <prelight/image.hpp>
#include <string>

namespace prelight::app::viewer {

/// Writes the picture to `name`, which has to end in .png; an empty one becomes prelight-N.png, the next that is free.
/// The file that was written. Throws Error.
std::filesystem::path save_screenshot(const Image& picture, const std::string& name);

/// Draws what the session shows now, and writes it for each screenshot that was asked for. Those that fail are told;
/// with `tells_all` those that are written too. Throws DeviceLost, Error.
void take_screenshots(Session& session, Drawer& drawer, bool tells_all);

} // namespace prelight::app::viewer
