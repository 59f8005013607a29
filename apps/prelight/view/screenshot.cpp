#include "screenshot.hpp"

#include "../argument.hpp"
#include "../interrupt.hpp"

#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight::app::viewer {

std::filesystem::path save_screenshot(const Image& picture, const std::string& name) {
    std::filesystem::path file = name;
    for (int i = 1; name.empty() && (file.empty() || std::filesystem::exists(file)); ++i)
        file = fmt::format("prelight-{}.png", i);
    if (lower_extension(file) != ".png")
        throw Error(fmt::format("screenshot {}: the name must end in .png", file.string()));
    const WriteGuard guard;
    save_png(picture, file);
    return file;
}

} // namespace prelight::app::viewer
