#include "renderer_box.hpp"
#include <prelight/timeline.hpp>

namespace prelight::python {
namespace {

/// Figures of frames that were drawn one by one.
class Frames {
public:
    void add(const Stats& stats) {
        wall_.push_back(stats.wall_ms.median);
        cpu_.push_back(stats.cpu_ms.median);
        gpu_.push_back(stats.gpu_ms.median);
        for (const PassStats& pass : stats.passes) {
            passes_[pass.name].push_back(pass.gpu_ms.median);
            if (pass.cpu_ms)
                pass_cpu_[pass.name].push_back(pass.cpu_ms->median);
        }
        last_ = stats;
    }
    Stats merged() const {
        Stats stats = last_;
        stats.frames = uint32_t(wall_.size());
        stats.wall_ms = spread(wall_);
        stats.cpu_ms = spread(cpu_);
        stats.gpu_ms = spread(gpu_);
        for (PassStats& pass : stats.passes) {
            pass.gpu_ms = spread(passes_.at(pass.name));
            if (pass.cpu_ms)
                pass.cpu_ms = spread(pass_cpu_.at(pass.name));
        }
        return stats;
    }

private:
    std::vector<double> wall_, cpu_, gpu_;
    std::map<std::string, std::vector<double>> passes_, pass_cpu_;
    Stats last_;
};

} // namespace

std::map<std::string, std::string> settings_given(const py::dict& given) {
    std::map<std::string, std::string> settings;
    for (const auto& [key, value] : given) {
        std::string name = py::str(key).cast<std::string>();
        std::replace(name.begin(), name.end(), '_', '-');
        if (py::isinstance<py::bool_>(value))
            settings[name] = value.cast<bool>() ? "on" : "off";
        else if (py::isinstance<py::str>(value) || py::isinstance<py::int_>(value) || py::isinstance<py::float_>(value))
            settings[name] = py::str(value).cast<std::string>();
        else
            throw py::type_error("setting " + name + ": a word or number is needed, not " +
                                 shape_of(py::reinterpret_borrow<py::object>(value)));
    }
    return settings;
}

RendererBox::RendererBox(std::string name, std::shared_ptr<DeviceBox> device, RenderOptions options)
    : name_(std::move(name)), options_(std::move(options)) {
    if (!std::isfinite(options_.exposure))
        throw UsageError("exposure: not finite");
    bool needs_device = false;
    for (const RendererInfo& info : renderer_infos())
        needs_device = needs_device || (info.name == name_ && info.needs_device);
    if (needs_device)
        device_ = device ? std::move(device) : default_device();
    without_gil([&] {
        const std::lock_guard lock(device_ ? device_->mutex : own_);
        renderer_ = create_renderer(name_, device_ ? device_->device.get() : nullptr, options_);
    });
}

RendererBox::~RendererBox() { close(); }

void RendererBox::close() {
    without_gil([&] {
        const std::lock_guard lock(device_ ? device_->mutex : own_);
        renderer_.reset();
        world_.reset();
        scene_.reset();
        shown_ = false;
    });
}

/// The renderer's own work: other Python threads run, and none uses the device.
template <class Work>
auto RendererBox::work(Work work) {
    return without_gil([&] {
        const std::lock_guard lock(device_ ? device_->mutex : own_);
        if (!renderer_)
            throw UsageError("renderer: it was closed");
        return work(*renderer_);
    });
}

void RendererBox::set_world(const WorldBox& box) {
    auto next = std::make_unique<World>(checked_copy(box));
    std::shared_ptr<const Scene> scene = box.scene;
    work([&](Renderer& renderer) {
        merged_.reset();
        const bool same = shown_ && scene == scene_;
        shown_ = false; // until all of it is there
        if (same) {
            // What has not changed stays on the device.
            WorldChanges changes = become(*world_, std::move(*next));
            changes.lights = changes.lights || lights_;
            renderer.update_world(changes);
        } else {
            renderer.set_world(*next);
            std::swap(world_, next);
            std::swap(scene_, scene);
        }
        lights_.reset();
        shown_ = true;
    });
}

void RendererBox::set_lights(const std::vector<PlacedLight>& lights) {
    work([&](Renderer& renderer) {
        if (!shown_)
            throw UsageError("renderer: set_world() comes before set_lights()");
        check_lights_given(*scene_, lights);
        merged_.reset();
        renderer.set_lights(lights);
        lights_ = lights;
    });
}

void RendererBox::resize(uint32_t width, uint32_t height) {
    work([&](Renderer& renderer) {
        renderer.resize(width, height);
        options_.width = width;
        options_.height = height;
        camera_.reset();
    });
}

void RendererBox::render(const py::object& camera, uint32_t frames, const py::object& progress) {
    if (frames == 0)
        throw UsageError("render: 0 frames");
    const CameraWish wish = camera_wish(camera);
    Frames drawn;
    for (uint32_t frame = 0; frame < frames; ++frame) {
        work([&](Renderer& renderer) {
            if (!shown_)
                throw UsageError("renderer: set_world() comes before render()");
            const PlacedCamera placed = find(wish, *world_, double(options_.width) / options_.height);
            merged_.reset();
            renderer.render(placed);
            camera_ = placed;
            if (frames > 1) {
                drawn.add(renderer.stats());
                merged_ = drawn.merged();
            }
        });
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
        if (!progress.is_none())
            progress(frame + 1, frames);
    }
}

Image RendererBox::read(const std::string& view) {
    return work([&](Renderer& renderer) {
        if (!camera_)
            throw UsageError("renderer: render() comes before read()");
        return renderer.read(view);
    });
}

Stats RendererBox::stats() {
    return work([&](Renderer& renderer) { return merged_ ? *merged_ : renderer.stats(); });
}

uint64_t RendererBox::max_lights() {
    return work([](Renderer& renderer) { return renderer.max_lights(); });
}

std::unique_ptr<ReferencePicture> RendererBox::reference() {
    std::shared_ptr<const Scene> scene; // which the world refers to
    World world;
    PlacedCamera camera;
    ReferenceRequest request{};
    work([&](Renderer& renderer) {
        if (!shown_ || !camera_)
            throw UsageError("renderer: render() comes before reference()");
        const Stats now = renderer.stats();
        scene = scene_;
        world = *world_;
        if (lights_)
            world.lights = *lights_;
        camera = *camera_;
        request = {options_.width, options_.height, options_.exposure, now.shading, now.settings, options_.msaa};
    });
    return reference_of(world, camera, request);
}

} // namespace prelight::python
