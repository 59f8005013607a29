// The window: input to events, events to the session, the session's picture to the screen.
#include "../../output.hpp"
#include "../../session.hpp"
#include "../../validation.hpp"
#include "../../watch.hpp"
#include "../drawer.hpp"
#include "../input_lag.hpp"
#include "../recording.hpp"
#include "../scale_control.hpp"
#include "../screenshot.hpp"
#include "../window_run.hpp"
#include "glfw_window.hpp"

#include "ui.hpp"
#include "ui_backend.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <future>
#include <imgui.h>
#include <platform/clocks.hpp>
#include <platform/program/interrupt.hpp>
#include <platform/program/watchdog.hpp>
#include <prelight/error.hpp>
#include <renderers/device_renderer.hpp>

namespace prelight::app::viewer {
namespace {

constexpr int settling_pictures = 3;          // of the panels, after input
constexpr double look_every_ms = 250;         // at files that may have changed, and at the plot
constexpr uint32_t most_steps_late = 15;      // after a pause longer than that the clock does not catch up
constexpr double draft_detail = 0.25;         // of the first picture, where the processor draws it
constexpr uint32_t small_picture = 640 * 360; // pixels that need no draft

class WindowLoop {
public:
    explicit WindowLoop(const ViewCommand& command)
        : command_(command), start_ms_(wall_ms()),
          window_("prelight", command.render.options.width, command.render.options.height),
          made_(std::async(std::launch::async,
                           [&, size = window_.extent()] {
                               return std::make_unique<Session>(command.render, size.width, size.height);
                           })),
          drawer_(command.render, GlfwWindow::extensions()), ui_(window_.handle(), window_.content_scale()),
          owned_(scene_with_set_up()), session_(*owned_), watch_(session_.files()), watched_(session_.loads()) {
        recording_.width = session_.window_width();
        recording_.height = session_.window_height();
        if (!command.play.empty())
            played_ = load_recording(command.play).events;
        drawer_.on_loss([this] { take_down(); }, [this] { set_up(); });
        if (command.scale && *command.scale != 1)
            take({0, "scale", {fmt::format("{}", *command.scale)}});
        take_sight();
    }

    void run() {
        const WatchdogPause waits; // for whoever sits before it
        draft_ =
            drawer_.draws_on_host(session_) && session_.picture_width() * session_.picture_height() > small_picture;
        drawer_.set_detail(draft_ ? draft_detail : 1);
        drawer_.follow(session_); // a start that cannot be is a failure, not a message
        clock_ms_ = renderer_ms_ = wall_ms();
        try {
            while (!session_.done() && !window_.closed()) {
                const double began = wall_ms();
                take_input();
                advance();
                picture(began);
                pace(began);
            }
        } catch (const Error&) { // what led there is worth keeping
            save_recording();
            throw;
        }
        save_recording();
        finish();
    }

private:
    /// What needs no scene is made while it is read, and whoever waits sees for what.
    std::unique_ptr<Session> scene_with_set_up() {
        set_up();
        ui_.wait(fmt::format("Reading {}", escaped(command_.render.scene)));
        try {
            show_over_picture();
        } catch (const gpu::SurfaceLost&) {
            // as the first picture will find out
        }
        window_ms_ = wall_ms();
        std::unique_ptr<Session> session = made_.get();
        scene_ms_ = wall_ms();
        return session;
    }

    void set_up() {
        auto& context = dynamic_cast<gpu::Context&>(*drawer_.device());
        presenter_.emplace(context, window_.make_surface(context.instance()));
        backend_.emplace(context, presenter_->format());
        redraw_ = settling_pictures;
    }
    void take_down() {
        backend_.reset();
        presenter_.reset();
    }

    void take_sight() {
        const Exposure exposure =
            first_sight(drawer_.device(), command_.render, session_.stage().world(), session_.camera(),
                        [&](const SceneEdit& edit) { session_.keep_edit(edit); });
        if (exposure.automatic)
            take({0, "exposure", {fmt::format("{}", exposure.ev)}});
    }

    static bool is_good(const Event& event) {
        try {
            check_event(event);
            return true;
        } catch (const Error&) {
            return false;
        }
    }

    void take(Event event) {
        event.step = session_.steps();
        if (!command_.record.empty() && is_good(event))
            recording_.events.push_back(event);
        session_.apply(event); // tells what is wrong with one that is not
    }

    void take_from_person(Event event) {
        input_ = true;
        lag_.take(session_.steps());
        take(std::move(event));
    }

    void take_input() {
        window_.capture(ui_.wants_mouse(), ui_.wants_keyboard());
        input_ = false;
        if (window_.take_stir())
            redraw_ = settling_pictures;
        if (window_.take_escape())
            ui_.focus_panels(false);
        for (Event& event : window_.take_events()) {
            if (event.verb == "key" && event.words == std::vector<std::string>{"Tab", "down"})
                ui_.focus_panels(true);
            take_from_person(std::move(event));
        }
        for (Event& event : std::exchange(asked_, {}))
            take_from_person(std::move(event));
        lag_.look();
        look_at_files();
        const std::string loss = session_.take_loss();
        if (loss == "device")
            drawer_.lose_device();
        if (loss == "surface")
            presenter_->lose_surface();
    }

    void look_at_files() {
        if (wall_ms() - looked_ms_ < look_every_ms)
            return;
        looked_ms_ = wall_ms();
        redraw_ = std::max(redraw_, 1);
        if (watched_ != session_.loads()) {
            watched_ = session_.loads();
            watch_ = FileWatch(session_.files());
        } else if (watch_.changed()) {
            take({0, "reload", {}});
        }
    }

    /// The session's clock up to now, with what a recording says on the way.
    void advance() {
        const double now = wall_ms();
        const double step_ms = 1000.0 / steps_per_second;
        auto due = static_cast<uint32_t>(std::max((now - clock_ms_) / step_ms, 0.0));
        if (due == 0 && input_ && clock_ms_ <= now)
            due = 1; // what was asked for is in this picture; the clock waits for itself afterwards
        if (due > most_steps_late) {
            due = 1;
            clock_ms_ = now - step_ms;
        }
        clock_ms_ += due * step_ms;
        for (uint32_t i = 0; i < due; ++i) {
            for (; next_played_ < played_.size() && played_[next_played_].step <= session_.steps(); ++next_played_)
                take(played_[next_played_]);
            session_.step();
            if (session_.changes().look) // as when it is played: refused at the step that asks for it
                drawer_.keep(session_, [&] { drawer_.follow(session_); });
            if (session_.wants_screenshots()) { // of that step too
                drawer_.set_detail(1);
                take_screenshots(session_, drawer_, true);
                session_.need_picture(); // which the screen has not seen
            }
        }
        if (!command_.play.empty() && command_.steps && session_.steps() >= *command_.steps)
            take({0, "quit", {}});
    }

    void picture(double began) {
        const bool changed = session_.changes().any();
        if (changed)
            changed_ms_ = began;
        else if (command_.scale == std::nullopt)
            if (const auto scale = control_.still((began - changed_ms_) / 1000, session_.scale()))
                take({0, "scale", {fmt::format("{}", *scale)}});
        if (!changed)
            lag_.rest(session_.steps());
        if (session_.minimised() || (!session_.changes().any() && redraw_ <= 0 && !ui_.busy()))
            return;
        redraw_ = std::max(redraw_ - 1, 0);
        try {
            drawer_.keep(session_, [&] { draw_and_show(); });
        } catch (const gpu::SurfaceLost& loss) {
            if (surface_lost_at_ && session_.steps() - *surface_lost_at_ < 10 * steps_per_second)
                throw;
            surface_lost_at_ = session_.steps();
            session_.tell(fmt::format("{}; there is another one", loss.what()));
            take_down();
            set_up();
            session_.need_picture();
        }
        if (changed && command_.scale == std::nullopt)
            if (const auto scale = control_.moving(wall_ms() - began, session_.scale()))
                take({0, "scale", {fmt::format("{}", *scale)}});
        add_figures(changed ? std::optional(wall_ms() - began) : std::nullopt);
    }

    void draw_and_show() {
        bool drawn = false;
        if (session_.changes().any()) {
            drawn = drawer_.draw(session_);
            if (drawn)
                hand_over();
        }
        std::vector<Event> asked = ui_.build(session_, figures_, in_force_);
        asked_.insert(asked_.end(), asked.begin(), asked.end());
        const bool shown = show_over_picture();
        if (!shown && drawn)
            session_.need_picture();
        if (shown)
            lag_.show(session_.steps());
        if (shown && first_)
            tell_first();
        else if (shown && drawn)
            tell_full();
    }

    void tell_first() {
        first_ = false;
        const double now = wall_ms();
        fmt::print("{}: first picture after {:.0f} ms (window {:.0f}, scene {:.0f}, renderer {:.0f}, picture {:.0f})\n",
                   escaped(command_.render.scene), now - start_ms_, window_ms_ - start_ms_, scene_ms_ - window_ms_,
                   renderer_ms_ - scene_ms_, now - renderer_ms_);
        std::fflush(stdout);
        if (draft_) {
            drawer_.set_detail(1);
            session_.need_picture();
        }
    }
    void tell_full() {
        if (!std::exchange(draft_, false))
            return;
        fmt::print("{}: in full after {:.0f} ms\n", escaped(command_.render.scene), wall_ms() - start_ms_);
        std::fflush(stdout);
    }

    bool show_over_picture() {
        return presenter_->show(window_.extent(),
                                [&](const gpu::OverlayContext& target) { backend_->draw(ui_.data(), target); });
    }

    void hand_over() {
        const std::string& buffer = session_.look().buffer;
        if (auto* renderer = dynamic_cast<DeviceRenderer*>(drawer_.renderer()))
            presenter_->take(renderer->shown(buffer));
        else
            presenter_->take(drawer_.read(buffer));
    }

    /// Of the frame before, mostly: nobody waits for this one.
    void add_figures(std::optional<double> shown_ms) {
        if (auto* renderer = dynamic_cast<DeviceRenderer*>(drawer_.renderer())) {
            figures_.add(renderer->last_frame(), shown_ms);
            in_force_ = renderer->settings_in_force();
        } else if (shown_ms) {
            figures_.add({}, shown_ms);
            in_force_ = drawer_.stats().settings;
        }
    }

    /// FIFO does not wait everywhere: no more pictures than the screen shows.
    void pace(double began) {
        const double picture_ms = 1000 / window_.refresh_rate();
        const double left = picture_ms - (wall_ms() - began);
        const bool idle = !session_.changes().any() && redraw_ <= 0 && asked_.empty();
        // Input ends the wait where nothing moves by itself; else it is as good at the next picture.
        if (idle) {
            window_.wait(std::max(left, 1.0) / 1000);
            return;
        }
        window_.wait(0);
        if (left > 0)
            std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(left));
        window_.wait(0); // what came meanwhile is in the next picture
    }

    void save_recording() const {
        if (command_.record.empty())
            return;
        const WriteGuard guard;
        save_text(recording_text(recording_), command_.record);
    }

    void finish() {
        drawer_.drop_renderer();
        take_down();
        check_validation(*drawer_.device());
        if (lag_.measured() > 0)
            fmt::print("{}: {} pictures; input was on the screen after {} at most\n", escaped(session_.scene_name()),
                       lag_.pictures(), lag_.most());
    }

    const ViewCommand& command_;
    double start_ms_;
    GlfwWindow window_;
    std::future<std::unique_ptr<Session>> made_; ///< while the device is opened
    Drawer drawer_;
    Ui ui_;
    std::optional<gpu::Presenter> presenter_;
    std::optional<UiBackend> backend_;
    int redraw_ = settling_pictures;
    double window_ms_ = 0, scene_ms_ = 0, renderer_ms_ = 0; ///< when there was one
    std::unique_ptr<Session> owned_;
    Session& session_;
    FileWatch watch_;
    uint32_t watched_ = 0; ///< Session::loads() of the files that are watched
    Recording recording_;
    std::vector<Event> played_, asked_; ///< asked_: by panels, for the next step
    size_t next_played_ = 0;
    Figures figures_;
    std::map<std::string, std::string> in_force_;
    ScaleControl control_;
    std::optional<uint32_t> surface_lost_at_; ///< step
    InputLag lag_;
    bool input_ = false;                ///< somebody has just asked for something
    bool first_ = true, draft_ = false; ///< no picture was shown yet; none but a draft
    double clock_ms_ = 0, looked_ms_ = 0, changed_ms_ = 0;
};

} // namespace

void run_window(const ViewCommand& command) { WindowLoop(command).run(); }

} // namespace prelight::app::viewer
