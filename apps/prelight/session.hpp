#pragma once
#include "command_line.hpp"

#include <prelight/device.hpp>
#include <prelight/renderer.hpp>

namespace prelight::app {

/// What outlives one picture: commands that draw many show scene after scene with it.
struct Session {
    std::unique_ptr<Device> device; ///< null for a renderer that needs none
    std::unique_ptr<Renderer> renderer;
    double exposure = 0; ///< of the renderer
};

/// The device and the renderer that the command asks for. With Edges::samples options.msaa becomes 4 if the device has
/// so many, there is memory for them, and no setting that was asked for gives way to them; else, and with
/// Edges::filtered, options.settings["antialiasing"] becomes smaa, where the renderer has it. Throws UsageError, Error.
Session open_session(RenderCommand& command, const RendererInfo& info);

/// What the picture itself decides of the command (take_first_sight()). `edit` does that to the world's scene.
Exposure first_sight(Device* device, const RenderCommand& command, const World& world, const PlacedCamera& camera,
                     std::function<void(const SceneEdit&)> edit);
/// The same, into the command; the renderer is made anew where it has another exposure.
void take_first_sight(Session& session, RenderCommand& command, const World& world, const PlacedCamera& camera,
                      std::function<void(const SceneEdit&)> edit);

/// The files that the command reads by name: --watch looks at these.
std::vector<std::filesystem::path> files_of(const RenderCommand& command);
/// These, and those that the scene's file names: no output may be one of them.
std::vector<std::filesystem::path> inputs_of(const RenderCommand& command);

/// Throws UsageError for a --view that the renderer does not have.
void check_views(const RenderCommand& command, const RendererInfo& info);

/// A picture in memory, and where it goes.
struct Picture {
    Image image;
    std::filesystem::path file;       ///< "-": standard output
    std::vector<float> coverage = {}; ///< its alpha; empty: opaque
};

/// What the command wants of the last frame, `output` first.
std::vector<Picture> read_pictures(Renderer& renderer, const RenderCommand& command);
/// Writes a whole file or none. Throws Error.
void save(const Picture& picture);
/// Of the scene's picture as it is displayed, when that is what was asked for: whether it is mostly black or burnt.
void warn_of_picture(const RenderCommand& command, const Picture& picture, const World& world);

} // namespace prelight::app
