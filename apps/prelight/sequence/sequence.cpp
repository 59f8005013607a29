#include "argument.hpp"
#include "commands.hpp"
#include "device_type.hpp"
#include "log.hpp"
#include "memory_check.hpp"
#include "output.hpp"
#include "own_materials.hpp"
#include "renderer_info.hpp"
#include "sequence/frame_drawer.hpp"
#include "sequence/frame_lines.hpp"
#include "sequence/sequence_json.hpp"
#include "sequence/video.hpp"
#include "session.hpp"
#include "start_up.hpp"
#include "validation.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight::app {
namespace {

/// Told before work that takes long.
void check_files(const SequenceCommand& command, const SequenceFiles& files) {
    for (const std::filesystem::path& file : files.at(0))
        check_writable(file);
    if (!command.render.stats.empty())
        check_writable(command.render.stats);
}

/// Draws what is planned; every frame is on the disk afterwards.
void draw_all(const SequenceCommand& command, const SequencePlan& plan, Video* video, FrameDrawer& drawer,
              Session& session) {
    FrameLines lines(plan.to_draw.size());
    // A video takes its frames in order; of pictures several can be packed at a time.
    const unsigned threads = video ? 1 : std::clamp(std::thread::hardware_concurrency(), 1u, 4u);
    FrameWriter writer(threads, [&](const DrawnFrame& frame) {
        std::optional<WriteGuard> whole_frame; // a video has no frame by itself, and can be ended at any time
        if (!video)
            whole_frame.emplace();
        for (size_t p = 0; p < frame.pictures.size(); ++p)
            video&& p == 0 ? video->add(frame.pictures[p].image) : save(frame.pictures[p]);
        lines.done(frame.number, frame.pictures[0].file);
    });
    drawer.draw(plan.to_draw, writer);
    writer.finish();
    if (video)
        video->finish();
    drawer.figures().seconds = lines.seconds();
    if (command.render.validate) {
        session.renderer.reset(); // taking everything down is checked too
        check_validation(*session.device);
    }
    const Stats stats = drawer.figures().stats.all();
    tell(fmt::format("{}: {} frame{}, {}x{}, {}, {} lights, {} triangles, {:.0f} frames an hour on {}",
                     command.render.output.string(), stats.frames, stats.frames == 1 ? "" : "s",
                     command.render.options.width, command.render.options.height, command.render.renderer, stats.lights,
                     stats.triangles, drawer.figures().frames_per_hour(), stats.device));
}

/// What of the list is not drawn now, and why.
void tell_plan(const SequenceCommand& command, const SequenceFiles& files, const SequencePlan& plan) {
    const std::string name = command.render.output.string();
    for (const uint32_t frame : plan.existing)
        tell(fmt::format("{}: frame {} is there", files.at(frame)[0].string(), frame));
    if (plan.wanted.empty())
        tell(fmt::format("{}: no frame for shard {}/{}", name, command.sequence.shard->index,
                         command.sequence.shard->count));
    else if (plan.to_draw.empty())
        tell(fmt::format("{}: all {} frames are there", name, plan.wanted.size()));
}

} // namespace

void run(const SequenceCommand& given) {
    SequenceCommand command = given;
    RenderCommand& render = command.render;
    const RendererInfo info = find_renderer(render.renderer);
    check_scene_name(render.scene);
    check_views(render, info);
    const SequenceFiles files(render);
    const std::vector<std::filesystem::path> inputs = inputs_of(render);
    files.check_frames({0}, render.stats, inputs);
    check_files(command, files);

    StartUp start_up;
    Stopwatch clock;
    std::optional<Video> video; // first of all: it may be missing
    if (files.video())
        video.emplace(render.output, render.options.width, render.options.height, command.sequence.rate);
    OwnMaterials materials(render.materials);
    const bool studio_where_dark = names_file(render.scene) && !render.lights;
    const SceneEdit edit = [&, environment = environment_edit(render.environment, studio_where_dark)](Scene& scene) {
        materials.assign(scene);
        environment(scene);
    };
    std::unique_ptr<SceneAtTime> scene; // before the renderer, which points into it until its end
    Session session = open_session(render, info);
    materials.check();
    start_up.device = clock.lap();
    const SceneTime time{Moment{}, render.animation, render.reading};
    const SceneView view{double(render.options.width) / render.options.height, render.framing};
    const size_t added = names_file(render.scene) ? render.lights.value_or(0) : 0;
    scene = std::make_unique<SceneAtTime>(
        load_scene(render.scene, render.lights, render.seed, session.renderer->max_lights(), time, edit, view), time,
        view, added, session.device != nullptr);
    const FrameNumbers all =
        all_frames(command.sequence, render.scene, scene->length(), !scene->scene().emitters.empty());
    files.check_numbered(all.size());
    const SequencePlan plan = plan_frames(command, files, all);
    files.check_frames(plan.to_draw, render.stats, inputs);
    tell_plan(command, files, plan);
    start_up.scene = clock.lap();

    FrameDrawer drawer(command, files, session, *scene);
    if (!plan.to_draw.empty()) {
        // At time 0, whichever frames are drawn: all tasks get the same.
        take_first_sight(session, render, scene->start(), drawer.camera(),
                         [&](const SceneEdit& change) { scene->edit(change); });
        if (session.device && type_of(*session.device) == "software")
            check_memory_for(scene->scene());
        draw_all(command, plan, video ? &*video : nullptr, drawer, session);
    }
    if (!render.stats.empty())
        save_text(sequence_json(command, plan, drawer.figures(), start_up, warnings_of(scene->start())), render.stats);
}

} // namespace prelight::app
