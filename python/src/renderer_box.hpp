#pragma once
#include "boxes.hpp"
#include "device_box.hpp"
#include <prelight/reference.hpp>

namespace prelight::python {

struct ReferenceRequest {
    uint32_t width, height;
    double exposure; ///< EV
    Shading shading;
    std::map<std::string, std::string> settings;
    uint32_t msaa;
};
/// Throws UsageError, Error.
std::unique_ptr<ReferencePicture> reference_of(const World& world, const PlacedCamera& camera,
                                               const ReferenceRequest& request);

/// Words, numbers and truths as the library reads them.
std::map<std::string, std::string> settings_given(const py::dict& given);

/// A renderer with what it shows.
class RendererBox {
public:
    RendererBox(std::string name, std::shared_ptr<DeviceBox> device, RenderOptions options);
    ~RendererBox();
    void close();

    void set_world(const WorldBox& box);
    void set_lights(const std::vector<PlacedLight>& lights);
    void resize(uint32_t width, uint32_t height);
    /// Frame by frame, so that signals are seen and `progress` told between two.
    void render(const py::object& camera, uint32_t frames, const py::object& progress);
    Image read(const std::string& view);
    Stats stats();
    uint64_t max_lights();
    std::unique_ptr<ReferencePicture> reference();

    const std::string& name() const { return name_; }
    const RenderOptions& options() const { return options_; }
    const std::shared_ptr<DeviceBox>& device() const { return device_; }

private:
    template <class Work>
    auto work(Work work);

    std::string name_;
    RenderOptions options_;
    std::shared_ptr<DeviceBox> device_; ///< null: it needs none
    std::mutex own_;                    ///< then
    std::shared_ptr<const Scene> scene_;
    std::unique_ptr<World> world_;                   ///< its own: the caller may do to his what he likes
    std::optional<std::vector<PlacedLight>> lights_; ///< of set_lights()
    std::optional<PlacedCamera> camera_;             ///< of the last frame
    std::optional<Stats> merged_;                    ///< of several frames
    bool shown_ = false;                             ///< the renderer has taken world_ in
    std::unique_ptr<Renderer> renderer_;             ///< goes first
};

} // namespace prelight::python
