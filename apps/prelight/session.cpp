#include "session.hpp"

#include "argument.hpp"
#include "memory_check.hpp"
#include "scene_files.hpp"
#include "scene_source.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <image/display_bytes.hpp>
#include <image/png_writer.hpp>
#include <platform/atomic_file.hpp>
#include <platform/program/interrupt.hpp>
#include <platform/program/standard_streams.hpp>
#include <prelight/error.hpp>
#include <prelight/views.hpp>

namespace prelight::app {
namespace {

/// Null: something was asked for that does not go with samples.
std::unique_ptr<Renderer> sampled_renderer(const RenderCommand& command, Device* device, const RenderOptions& options) {
    std::unique_ptr<Renderer> renderer;
    try {
        renderer = create_renderer(command.renderer, device, options);
    } catch (const UsageError&) {
        return nullptr; // if it is a mistake, that of one sample says so
    }
    const std::map<std::string, std::string> in_force = renderer->stats().settings;
    for (const auto& [key, value] : command.options.settings)
        if (value != "auto" && in_force.at(key) != value)
            return nullptr;
    return renderer;
}

std::unique_ptr<Renderer> smooth_renderer(RenderCommand& command, Device* device, const RendererInfo& info) {
    constexpr uint32_t samples = 4;
    RenderOptions options = command.options;
    options.msaa = samples;
    if (command.edges == Edges::samples && device->has_samples(samples) &&
        fits_frame(options.width, options.height, samples))
        if (auto renderer = sampled_renderer(command, device, options)) {
            command.options.msaa = samples;
            return renderer;
        }
    if (std::ranges::find(info.settings, "antialiasing", &SettingInfo::key) != info.settings.end())
        command.options.settings["antialiasing"] = "smaa";
    return create_renderer(command.renderer, device, command.options);
}

std::vector<std::byte> png_of(const Picture& picture) {
    const std::vector<uint8_t> rgb = display_bytes(picture.image);
    const Image& image = picture.image;
    if (picture.coverage.empty())
        return encode_png(image.width, image.height, 3, rgb);
    std::vector<uint8_t> rgba;
    rgba.reserve(rgb.size() / 3 * 4);
    for (size_t i = 0; i < picture.coverage.size(); ++i) {
        rgba.insert(rgba.end(), rgb.begin() + static_cast<std::ptrdiff_t>(3 * i),
                    rgb.begin() + static_cast<std::ptrdiff_t>(3 * i + 3));
        rgba.push_back(static_cast<uint8_t>(std::lround(255 * picture.coverage[i])));
    }
    return encode_png(image.width, image.height, 4, rgba);
}

} // namespace

Session open_session(RenderCommand& command, const RendererInfo& info) {
    if (!info.needs_device && (command.validate || command.device != "auto"))
        throw UsageError(fmt::format("{}: renderer {} uses no Vulkan device",
                                     command.validate ? "--validate" : "--device", info.name));
    Session session;
    session.exposure = command.options.exposure;
    if (info.needs_device)
        session.device = open_device({.select = command.device, .validate = command.validate}, command.options.width,
                                     command.options.height, command.options.msaa);
    session.renderer = command.edges != Edges::as_told && session.device
                           ? smooth_renderer(command, session.device.get(), info)
                           : create_renderer(command.renderer, session.device.get(), command.options);
    return session;
}

Exposure first_sight(Device* device, const RenderCommand& command, const World& world, const PlacedCamera& camera,
                     std::function<void(const SceneEdit&)> edit) {
    const bool display = command.view == "final" && lower_extension(command.output) != ".exr"; // which loses nothing
    return take_first_sight({.device = device,
                             .world = world,
                             .camera = camera,
                             .options = command.options,
                             .exposure = command.exposure,
                             .environment = command.environment,
                             .lit_file = names_file(command.scene) && !command.lights,
                             .display = display,
                             .edit = std::move(edit)});
}

void take_first_sight(Session& session, RenderCommand& command, const World& world, const PlacedCamera& camera,
                      std::function<void(const SceneEdit&)> edit) {
    const Exposure exposure = first_sight(session.device.get(), command, world, camera, std::move(edit));
    if (exposure.automatic)
        command.exposure = ExposureChoice::automatic;
    command.options.exposure = exposure.ev;
    if (exposure.ev == session.exposure)
        return;
    session.exposure = exposure.ev;
    session.renderer.reset(); // before another is there: it holds memory
    session.renderer = create_renderer(command.renderer, session.device.get(), command.options);
}

std::vector<std::filesystem::path> files_of(const RenderCommand& command) {
    std::vector<std::filesystem::path> files;
    if (names_file(command.scene) && !is_standard_stream(command.scene))
        files.emplace_back(command.scene);
    for (const auto& [name, file] : command.materials)
        files.push_back(file);
    if (!command.environment.file.empty())
        files.push_back(command.environment.file);
    return files;
}

std::vector<std::filesystem::path> inputs_of(const RenderCommand& command) {
    std::vector<std::filesystem::path> inputs = files_of(command);
    for (std::filesystem::path& file : files_named_in(command.scene))
        inputs.push_back(std::move(file));
    return inputs;
}

void check_views(const RenderCommand& command, const RendererInfo& info) {
    for (const std::string& view : command.options.views)
        if (view != "final" && view != "linear" && !has_view(info, view))
            throw UsageError(fmt::format("--view {}: {} has {}{}", view, info.name, names_of_views(info),
                                         did_you_mean(view, info.views)));
}

std::vector<Picture> read_pictures(Renderer& renderer, const RenderCommand& command) {
    const bool exr = lower_extension(command.output) == ".exr";
    std::vector<Picture> pictures;
    pictures.push_back({renderer.read(exr ? "linear" : command.view), command.output});
    for (const ViewFile& more : command.more_views)
        pictures.push_back({renderer.read(more.view), more.file});
    return pictures;
}

void save(const Picture& picture) {
    const WriteGuard guard;
    if (lower_extension(picture.file) == ".exr")
        return save_exr(picture.image, picture.file);
    const bool piped = is_standard_stream(picture.file);
    if (!piped && picture.coverage.empty())
        return save_png(picture.image, picture.file);
    const std::vector<std::byte> bytes = png_of(picture);
    if (piped)
        return write_standard_output(bytes);
    AtomicFile file(picture.file);
    file.write(bytes);
    file.commit();
}

void warn_of_picture(const RenderCommand& command, const Picture& picture, const World& world) {
    if (command.view != "final" && command.view != "linear")
        return;
    const bool linear = lower_extension(picture.file) == ".exr";
    const Image shown = linear ? tonemap(picture.image, command.options.tonemap) : Image();
    warn_of_extremes(Log(command.reading.log_level), linear ? shown : picture.image, picture.file.string(), world,
                     command.exposure == ExposureChoice::automatic);
}

} // namespace prelight::app
