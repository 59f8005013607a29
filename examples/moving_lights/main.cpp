// What lights that all move cost: example_moving_lights [LIGHTS [LIGHT-CULLING [FRAMES]]]. The scene
// `lights` at 1280x720, every light on a circle of its own, new places before each frame. The range
// shrinks with the count, so that about as many lights meet a pixel as with 1,024. Prints medians.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <prelight/device.hpp>
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>
#include <prelight/scene_io.hpp>
#include <string_view>

namespace {

using namespace prelight;

uint32_t number(std::string_view text) {
    uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || value == 0)
        throw UsageError(fmt::format("{}: not a number above 0", text));
    return value;
}

class Swarm {
public:
    explicit Swarm(std::vector<PlacedLight> lights) : rest_(std::move(lights)), now_(rest_) {}
    std::span<const PlacedLight> at(double time) {
        for (size_t i = 0; i < rest_.size(); ++i) {
            const double angle = time + 2.4 * static_cast<double>(i);
            now_[i].position = rest_[i].position + 0.3 * glm::dvec3(std::cos(angle), 0, std::sin(angle));
        }
        return now_;
    }

private:
    std::vector<PlacedLight> rest_, now_;
};

/// One frame a step; each waits only for the frame before the last, as a program's own loop would.
void run(uint32_t count, const std::string& culling, uint32_t frames) {
    const Scene scene = make_scene("lights", count, 1);
    World world = resolve(scene);
    for (PlacedLight& placed : world.lights)
        placed.light.range *= static_cast<float>(std::sqrt(1024.0 / count));
    Swarm swarm(world.lights);

    const std::unique_ptr<Device> device = Device::create({});
    RenderOptions options;
    options.settings = {{"light-culling", culling}};
    const std::unique_ptr<Renderer> renderer = create_renderer("light-prepass", device.get(), options);
    renderer->set_world(world);
    const auto step = [&](uint32_t frame) {
        renderer->set_lights(swarm.at(0.05 * frame));
        renderer->render(world.cameras[0]);
    };
    for (uint32_t frame = 0; frame < 3; ++frame)
        step(frame); // pipelines are warm, lists have their room
    std::vector<double> lights, culled, objects, record, building;
    for (uint32_t frame = 3; frame < 3 + frames; ++frame) {
        step(frame);
        const Stats stats = renderer->stats();
        lights.push_back(stats.host_ms->lights.median);
        culled.push_back(stats.host_ms->culling.median);
        objects.push_back(stats.host_ms->objects.median);
        record.push_back(stats.host_ms->record.median);
        double lists = 0;
        for (const PassStats& pass : stats.passes)
            if (pass.name.find("-lists") != std::string::npos || pass.name == "depth-range")
                lists += pass.gpu_ms.median;
        building.push_back(lists);
    }
    fmt::print("{} lights, {}: host {:.2f} ms lights, {:.2f} culling, {:.2f} objects, {:.2f} recording; "
               "device {:.2f} ms building lists\n",
               count, culling, spread(lights).median, spread(culled).median, spread(objects).median,
               spread(record).median, spread(building).median);
}

} // namespace

int main(int argc, char** argv) {
    try {
        run(argc > 1 ? number(argv[1]) : 65536, argc > 2 ? argv[2] : "clusters", argc > 3 ? number(argv[3]) : 9);
        return 0;
    } catch (const prelight::Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
