#include "argument.hpp"
#include "commands.hpp"
#include "coverage.hpp"
#include "device_type.hpp"
#include "memory_check.hpp"
#include "output.hpp"
#include "own_materials.hpp"
#include "renderer_info.hpp"
#include "scene_source.hpp"
#include "session.hpp"
#include "stats_json.hpp"
#include "validation.hpp"
#include "watch.hpp"

#include <fmt/format.h>
#include <future>
#include <platform/program/standard_streams.hpp>
#include <prelight/error.hpp>

namespace prelight::app {
namespace {

void check_before_work(const RenderCommand& command, const RendererInfo& info) {
    check_views(command, info);
    if (command.watch && !names_file(command.scene) && command.materials.empty() && command.environment.file.empty())
        throw UsageError(fmt::format("--watch: {} is not a file that could change", command.scene));
    const std::vector<std::filesystem::path> outputs = outputs_of(command);
    check_distinct(outputs, inputs_of(command));
    for (const std::filesystem::path& output : outputs)
        check_writable(output);
}

/// Puts the picture on what the command wants behind it.
void lay_behind(Picture& picture, const Session& session, const RenderCommand& command, LoadedScene& loaded,
                const PlacedCamera& camera) {
    std::vector<float> coverage = coverage_of(session, command, loaded, camera);
    if (command.environment.background == Background::colour)
        return put_over(picture.image, coverage, command.environment.colour);
    take_off_black(picture.image, coverage);
    picture.coverage = std::move(coverage);
}

void render_once(Session& session, const RenderCommand& given, LoadedScene& loaded, StartUp& start_up) {
    RenderCommand command = given; // of a changed file other things may be decided
    Stopwatch watch;
    const PlacedCamera& camera =
        command.camera.empty() ? loaded.world.cameras.at(0) : find_camera(loaded.world, command.camera);
    take_first_sight(session, command, loaded.world, camera, [&](const SceneEdit& edit) { edit(loaded.scene); });
    if (session.device && type_of(*session.device) == "software")
        check_memory_for(loaded.scene);
    session.renderer->set_world(loaded.world);
    start_up.world = watch.lap();
    session.renderer->render(camera, command.frames);
    const Stats stats = session.renderer->stats(); // waits for the frames
    start_up.frames = watch.lap();
    std::vector<Picture> pictures = read_pictures(*session.renderer, command);
    if (command.environment.see_through())
        lay_behind(pictures[0], session, command, loaded, camera);
    for (const std::string& note : stats.notes)
        Log(command.reading.log_level).note(note);
    if (command.validate && !command.watch)
        session.renderer.reset(); // taking everything down is checked too
    if (session.device)
        check_validation(*session.device);
    for (const Picture& picture : pictures)
        save(picture);
    warn_of_picture(command, pictures[0], loaded.world);
    start_up.picture = watch.lap();
    if (!command.stats.empty())
        save_text(stats_json(command, stats, start_up, warnings_of(loaded.world)), command.stats);
    tell(fmt::format("{}: {}x{}, {}, {} lights, {} triangles, {:.1f} ms a frame on {}", command.output.string(),
                     command.options.width, command.options.height, command.renderer, stats.lights, stats.triangles,
                     stats.wall_ms.median, stats.device));
}

/// "out/{name}.png" → "out/city.png": a file's name without folder and ending, or a built-in scene's.
std::filesystem::path filled(const std::filesystem::path& file, const std::string& scene) {
    constexpr std::string_view mark = "{name}";
    const std::string name = is_standard_stream(scene) ? "stdin"
                             : names_file(scene)       ? std::filesystem::path(scene).stem().string()
                                                       : scene;
    std::string text = file.string();
    for (size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + name.size()))
        text.replace(at, mark.size(), name);
    return text;
}

/// The command for one of its scenes.
RenderCommand command_for(const RenderCommand& command, const std::string& scene) {
    RenderCommand one = command;
    one.scene = scene;
    one.more_scenes.clear();
    one.output = filled(command.output, scene);
    one.stats = filled(command.stats, scene);
    for (ViewFile& view : one.more_views)
        view.file = filled(view.file, scene);
    return one;
}

void render_scene(const RenderCommand& given) {
    RenderCommand command = given;
    const RendererInfo info = find_renderer(command.renderer);
    check_scene_name(command.scene);
    check_before_work(command, info);

    // The renderer comes before a file, and so do materials: wrong usage and mistakes are told before a long
    // load. A built-in scene is made meanwhile.
    StartUp start_up;
    Stopwatch clock;
    std::future<Scene> built_in;
    if (names_builtin(command.scene))
        built_in =
            std::async(std::launch::async, [&] { return make_builtin(command.scene, command.lights, command.seed); });
    OwnMaterials materials(command.materials);
    // Added lights are lights too: whoever wants the studio beside them says so.
    const bool studio_where_dark = names_file(command.scene) && !command.lights;
    const SceneEdit edit = [&, environment = environment_edit(command.environment, studio_where_dark)](Scene& scene) {
        materials.assign(scene);
        environment(scene);
    };
    Session session = open_session(command, info);
    materials.check();
    FileWatch watch(files_of(command));
    start_up.device = clock.lap();
    const SceneTime time{command.moment, command.animation, command.reading};
    const SceneView view{double(command.options.width) / command.options.height, command.framing};
    const auto load = [&] {
        return load_scene(command.scene, command.lights, command.seed, session.renderer->max_lights(), time, edit,
                          view);
    };
    std::unique_ptr<LoadedScene> loaded = built_in.valid() ? resolve_builtin(built_in.get(), time, edit, view) : load();
    start_up.scene = clock.lap();
    render_once(session, command, *loaded, start_up);

    while (command.watch) {
        watch.wait();
        for (const std::string& mistake : materials.take_changes())
            fmt::print(stderr, "prelight: {}\n", mistake);
        std::unique_ptr<LoadedScene> changed;
        try {
            changed = load();
            render_once(session, command, *changed, start_up);
        } catch (const Error& error) {
            // Mostly a file caught half written: the next change sets it right.
            fmt::print(stderr, "prelight: {}\n", error.what());
        }
        if (changed) // the renderer may point into it from now on
            loaded = std::move(changed);
    }
}

} // namespace

void run(const RenderCommand& command) {
    std::vector<RenderCommand> commands{command_for(command, command.scene)};
    for (const std::string& scene : command.more_scenes)
        commands.push_back(command_for(command, scene));
    std::vector<std::filesystem::path> outputs, inputs;
    for (const RenderCommand& one : commands) { // before any of them is drawn
        check_scene_name(one.scene);
        for (std::vector<std::filesystem::path> files = outputs_of(one); std::filesystem::path & file : files)
            outputs.push_back(std::move(file));
        for (std::vector<std::filesystem::path> files = inputs_of(one); std::filesystem::path & file : files)
            inputs.push_back(std::move(file));
    }
    check_distinct(outputs, inputs);
    for (const RenderCommand& one : commands)
        render_scene(one);
}

} // namespace prelight::app
