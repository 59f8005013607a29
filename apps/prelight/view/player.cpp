#include "player.hpp"

#include "../argument.hpp"
#include "../output.hpp"
#include "../session.hpp"
#include "../validation.hpp"
#include "drawer.hpp"
#include "recording.hpp"
#include "screenshot.hpp"

#include <array>
#include <fmt/format.h>
#include <platform/program/interrupt.hpp>
#include <prelight/error.hpp>

namespace prelight::app::viewer {
namespace {

/// What the session has to say goes to stderr: there is no panel.
void print_messages(Session& session) {
    for (const std::string& message : session.messages())
        fmt::print(stderr, "prelight: view: step {}: {}\n", session.steps(), message);
    session.dismiss_messages();
}

} // namespace

void play(const ViewCommand& command) {
    const Recording recording = load_recording(command.play);
    const uint32_t last = recording.events.empty() ? 0 : recording.events.back().step;
    const uint32_t steps = command.steps.value_or(last + 1);
    RenderCommand render = command.render;
    render.options.width = recording.width;
    render.options.height = recording.height;

    Drawer drawer(render, {});
    Session session(render, recording.width, recording.height);
    const Exposure exposure = first_sight(drawer.device(), render, session.stage().world(), session.camera(),
                                          [&](const SceneEdit& edit) { session.keep_edit(edit); });
    if (exposure.automatic)
        session.apply({0, "exposure", {fmt::format("{}", exposure.ev)}});
    if (command.scale)
        session.apply({0, "scale", {fmt::format("{}", *command.scale)}});
    drawer.follow(session); // a start that cannot be is a failure
    auto event = recording.events.begin();
    while (session.steps() < steps && !session.done()) {
        for (; event != recording.events.end() && event->step == session.steps(); ++event)
            session.apply(*event);
        if (session.take_loss() == "device")
            drawer.lose_device();
        session.step();
        // As a window would: a renderer that cannot be is refused at the step that asks for it.
        drawer.keep(session, [&] {
            if (render.validate && session.changes().any())
                drawer.draw(session);
            else if (session.changes().look)
                drawer.follow(session);
        });
        take_screenshots(session, drawer, false);
        print_messages(session);
    }
    if (session.minimised())
        throw Error(fmt::format("{}: ends minimised: there is no picture", command.play.string()));
    drawer.keep(session, [&] { drawer.draw(session); });
    print_messages(session);
    const bool exr = lower_extension(render.output) == ".exr";
    if (exr && session.look().buffer != "final")
        throw Error(fmt::format("{}: ends with {} on show, of which there is no scene-linear picture: write a .png",
                                command.play.string(), session.look().buffer));
    const Image picture = drawer.read(exr ? "linear" : session.look().buffer);
    const Stats stats = drawer.stats();
    drawer.drop_renderer(); // taking everything down is checked too
    check_validation(*drawer.device());
    {
        const WriteGuard guard;
        exr ? save_exr(picture, render.output) : save_png(picture, render.output);
    }
    fmt::print("{}: {}x{}, {}, {} lights, step {} of {}\n", escaped(render.output.string()), picture.width,
               picture.height, session.look().renderer, stats.lights, session.steps(), escaped(command.play.string()));
}

} // namespace prelight::app::viewer
