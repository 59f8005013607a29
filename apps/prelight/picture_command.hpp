#pragma once
#include "command_line.hpp"

namespace prelight::app {

class Given;

/// `--exposure`: a number goes into the options. Throws UsageError.
ExposureChoice take_exposure(const Given& given, RenderOptions& options);
/// "--set KEY=VALUE" as often as it was given, into `settings`. With a renderer each is checked, in the order in which
/// they were typed. Throws UsageError.
void take_settings(const Given& given, const RendererInfo* info, std::map<std::string, std::string>& settings);

/// What `render`, `sequence` and `view` share: all but the moment. Throws UsageError.
RenderCommand parse_picture(const Given& given);

} // namespace prelight::app
