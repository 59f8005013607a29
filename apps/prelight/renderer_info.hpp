#pragma once
#include <prelight/renderer.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace prelight::app {

/// Of all there are.
std::vector<std::string> renderer_names();

/// Throws UsageError naming the renderers there are.
RendererInfo find_renderer(const std::string& name);

/// What `prelight renderers NAME` prints.
std::string renderer_text(const RendererInfo& info);

/// The keys of its settings.
std::vector<std::string> keys_of(const RendererInfo& info);

/// Each throws UsageError, beginning with what was typed, where the renderer has no such setting, value or preset. What
/// settings need of each other is the renderer's own check.
void check_setting(std::string_view as_typed, const RendererInfo& info, const std::string& key,
                   const std::string& value);
void check_preset(std::string_view as_typed, const RendererInfo& info, const std::string& preset);

} // namespace prelight::app
