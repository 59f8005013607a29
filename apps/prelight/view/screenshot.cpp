#include "screenshot.hpp"

#include "../argument.hpp"

#include <fmt/format.h>
#include <platform/program/interrupt.hpp>
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

void take_screenshots(Session& session, Drawer& drawer, bool tells_all) {
    for (const std::string& name : session.take_screenshots())
        drawer.keep(session, [&] {
            if (!drawer.draw(session))
                return session.tell(fmt::format("screenshot {}: a window that is minimised has no picture", name));
            try {
                const auto file = save_screenshot(drawer.read(session.look().buffer), name);
                if (tells_all)
                    session.tell(fmt::format("{} is written", file.string()));
            } catch (const DeviceLost&) {
                throw;
            } catch (const Error& error) {
                session.tell(error.what());
            }
        });
}

} // namespace prelight::app::viewer
