#include "light_pass.hpp"
#include "light_volumes.hpp"

namespace prelight::passes {

void light_pass(graph::FrameGraph& graph, const resident::Frame& frame, const std::string& name,
                const LightingInputs& inputs) {
    switch (frame.culling()) {
    case resident::LightCulling::fullscreen:
    case resident::LightCulling::volumes: return light_volume_pass(graph, frame, name, inputs);
    }
}

SettingInfo light_culling_setting() {
    return {"light-culling", {"volumes", "fullscreen"}, "volumes", "how a light finds its pixels"};
}

resident::LightCulling light_culling(const std::string& value) {
    return value == "fullscreen" ? resident::LightCulling::fullscreen : resident::LightCulling::volumes;
}

} // namespace prelight::passes
