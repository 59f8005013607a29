#include "drawer.hpp"

#include "../memory_check.hpp"
#include "../validation.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gpu/context.hpp>
#include <prelight/error.hpp>

namespace prelight::app::viewer {

Drawer::Drawer(const RenderCommand& command, std::vector<std::string> window_extensions)
    : command_(command), window_extensions_(std::move(window_extensions)) {
    open();
}

void Drawer::open() {
    DeviceOptions options{.select = command_.device, .validate = command_.validate};
    options.window_extensions = window_extensions_;
    device_ = open_device(options, command_.options.width, command_.options.height, command_.options.msaa);
    software_ = dynamic_cast<gpu::Context&>(*device_).is_software();
}

uint32_t Drawer::scaled(uint32_t pixels) const {
    return std::max(static_cast<uint32_t>(std::lround(pixels * detail_)), 1u);
}

bool Drawer::draws_on_host(const Session& session) const { return software_ || session.look().renderer == "reference"; }

bool Drawer::make_renderer(Session& session) {
    const Look& look = session.look();
    RenderOptions options = look.options;
    options.width = scaled(session.picture_width());
    options.height = scaled(session.picture_height());
    try {
        auto next = create_renderer(look.renderer, device_.get(), options);
        check_memory(session);
        next->set_world(session.stage().world());
        session.stage().take_changes();
        renderer_ = std::move(next);
    } catch (const DeviceLost&) {
        throw;
    } catch (const Error& error) {
        if (!renderer_)
            throw;
        session.refuse_look(error.what());
        return false;
    }
    width_ = options.width;
    height_ = options.height;
    session.accept_look();
    return true;
}

void Drawer::follow(Session& session) {
    if (session.minimised())
        return;
    const Changes changes = session.take_changes();
    if (changes.any())
        session.need_picture();               // until one is drawn
    bool world = changes.scene || !renderer_; // to be taken in whole
    bool lights = changes.lights || world || changes.world;
    if (changes.look || !renderer_) {
        const bool made = make_renderer(session);
        world &= !made;
        lights |= made;
    }
    const uint32_t width = scaled(session.picture_width()), height = scaled(session.picture_height());
    if (width_ != width || height_ != height) {
        renderer_->resize(width, height);
        width_ = width;
        height_ = height;
    }
    WorldChanges moved = session.stage().take_changes();
    moved.lights = false; // below
    if (world)
        take_scene(session);
    else if (!moved.empty())
        renderer_->update_world(moved);
    session.forget_earlier();
    if (lights)
        renderer_->set_lights(session.shining());
}

void Drawer::check_memory(const Session& session) {
    if (!software_ || checked_ == &session.stage().scene())
        return;
    check_memory_for(session.stage().scene());
    checked_ = &session.stage().scene();
}

/// One that does not fit gives way to the one before it.
void Drawer::take_scene(Session& session) {
    try {
        check_memory(session);
        renderer_->set_world(session.stage().world());
    } catch (const DeviceLost&) {
        throw;
    } catch (const Error& error) {
        if (!session.go_back(error.what()))
            throw;
        renderer_->set_world(session.stage().world());
    }
    session.stage().take_changes();
}

bool Drawer::draw(Session& session) {
    if (session.minimised())
        return false;
    follow(session);
    session.take_changes();
    renderer_->render(session.camera());
    return true;
}

void Drawer::lose_device() { dynamic_cast<gpu::Context&>(*device_).lose(); }

void Drawer::keep(Session& session, const std::function<void()>& work) {
    try {
        work();
    } catch (const DeviceLost& loss) {
        if (lost_at_ && session.steps() - *lost_at_ < 10 * steps_per_second)
            throw;
        lost_at_ = session.steps();
        session.tell(fmt::format("{}; everything was made anew", loss.what()));
        recover(session);
        work();
    }
}

void Drawer::recover(Session& session) {
    if (down_)
        down_();
    renderer_.reset();
    check_validation(*device_);
    device_.reset();
    open();
    if (up_)
        up_();
    session.renew();
}

} // namespace prelight::app::viewer
