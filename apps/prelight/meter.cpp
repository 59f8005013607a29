#include "meter.hpp"

#include "renderer_info.hpp"

#include <algorithm>
#include <cmath>
#include <prelight/exposure.hpp>

namespace prelight::app {
namespace {

constexpr uint32_t longest_side = 256;

/// The command's settings that say what light there is, as far as this renderer has them.
std::map<std::string, std::string> settings_of_light(const RendererInfo& info, const RenderOptions& options) {
    std::map<std::string, std::string> settings;
    for (const char* key : {"shadows", "ssao", "ssao-radius", "ambient-occlusion", "ambient-occlusion-radius"})
        if (const auto given = options.settings.find(key);
            given != options.settings.end() &&
            std::ranges::find(info.settings, key, &SettingInfo::key) != info.settings.end())
            settings[key] = given->second;
    return settings;
}

const char* architecture(const Device* device) { return device ? "light-prepass" : "reference"; }

} // namespace

Meter::Meter(Device* device, const PlacedCamera& camera, const RenderOptions& options)
    : device_(device), camera_(camera) {
    const double scale = std::min(1.0, double(longest_side) / std::max(options.width, options.height));
    const auto side = [&](uint32_t pixels) { return std::max(uint32_t(std::lround(pixels * scale)), 1u); };
    small_ = {.width = side(options.width),
              .height = side(options.height),
              .shading = options.shading,
              .tonemap = options.tonemap,
              .preset = {},
              .settings = settings_of_light(find_renderer(architecture(device)), options),
              .views = {"depth", "linear"}};
}

void Meter::draw(double ev) {
    if (!renderer_ || small_.exposure != ev) {
        small_.exposure = ev;
        renderer_.reset();
        renderer_ = create_renderer(architecture(device_), device_, small_);
    }
    renderer_->set_world(*world_);
    renderer_->render(camera_);
    linear_ = renderer_->read("linear");
    surface_.clear();
    for (const glm::vec3& p : renderer_->read("depth").pixels)
        surface_.push_back(p.r > 0);
}

void Meter::look(const World& world) {
    world_ = &world;
    exposure_.reset();
    draw(0);
}

double Meter::exposure() {
    if (exposure_)
        return *exposure_;
    // A half float holds forty stops: what is far off is metered again, nearer to its middle, and what is black once
    // more with more light.
    double ev = small_.exposure;
    bool lit = false;
    for (int tries = 0; tries < 4; ++tries) {
        if (tries > 0)
            draw(ev);
        const std::optional<double> more = auto_exposure(linear_, surface_);
        lit |= more.has_value();
        ev = std::clamp(ev + more.value_or(24), -64.0, 64.0);
        if (more && std::abs(*more) < 8)
            break;
        if (!lit && tries == 1) { // nothing shines
            ev = 0;
            break;
        }
    }
    exposure_ = ev;
    return ev;
}

Image Meter::linear_at(double ev) const {
    Image linear = linear_;
    const auto factor = static_cast<float>(std::exp2(ev - small_.exposure));
    for (glm::vec3& p : linear.pixels)
        p *= factor;
    return linear;
}

double Meter::over_white() const {
    const Image linear = linear_at(0);
    double surfaces = 0, over = 0;
    for (size_t i = 0; i < surface_.size(); ++i) {
        const glm::vec3& p = linear.pixels[i];
        surfaces += surface_[i];
        over += surface_[i] && std::max({p.r, p.g, p.b}) > 1;
    }
    return over / std::max(surfaces, 1.0);
}

double Meter::black(double ev) const { return find_extremes(tonemap(linear_at(ev), small_.tonemap)).black; }

} // namespace prelight::app
