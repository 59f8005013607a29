#pragma once
#include "session.hpp"

#include <functional>
#include <prelight/device.hpp>
#include <prelight/renderer.hpp>

namespace prelight::app::viewer {

/// Keeps a renderer in step with a session, and draws.
class Drawer {
public:
    /// Opens the device. `window_extensions`: DeviceOptions::window_extensions. Throws Error, UsageError.
    Drawer(const RenderCommand& command, std::vector<std::string> window_extensions);

    /// The renderer becomes what the session wants. What it cannot have is told there, and the last one that it could
    /// have stays; the first one has to be. Throws DeviceLost, Error.
    void follow(Session& session);
    /// The same, and a frame. False: the window is minimised.
    bool draw(Session& session);
    /// Of the last frame.
    Image read(std::string_view view) { return renderer_->read(view); }
    Stats stats() const { return renderer_->stats(); }

    /// Pixels drawn for one of the session's, along each side, from the next picture on: fewer give a draft sooner.
    void set_detail(double detail) { detail_ = detail; }
    /// Whether a picture takes the processor's time.
    bool draws_on_host(const Session& session) const;

    Device* device() { return device_.get(); }
    Renderer* renderer() { return renderer_.get(); }
    /// A test's: the device is lost now.
    void lose_device();
    /// What is on the device beside the renderer: `down` before the device goes at a loss, `up` when there is another.
    void on_loss(std::function<void()> down, std::function<void()> up) {
        down_ = std::move(down);
        up_ = std::move(up);
    }
    /// Does `work`; when the device is lost meanwhile, makes everything anew on a new one and does it once more. Throws
    /// DeviceLost at the second loss within ten seconds of the session.
    void keep(Session& session, const std::function<void()>& work);
    void drop_renderer() { renderer_.reset(); }

private:
    void open();
    bool make_renderer(Session& session);
    void check_memory(const Session& session);
    void take_scene(Session& session);
    void recover(Session& session);
    uint32_t scaled(uint32_t pixels) const;

    RenderCommand command_;
    std::vector<std::string> window_extensions_;
    std::unique_ptr<Device> device_;
    std::unique_ptr<Renderer> renderer_;
    bool software_ = false;
    double detail_ = 1;
    const Scene* checked_ = nullptr;  ///< there is memory for it
    uint32_t width_ = 0, height_ = 0; ///< of its pictures
    std::optional<uint32_t> lost_at_; ///< step
    std::function<void()> down_, up_;
};

} // namespace prelight::app::viewer
