#include "sequence/frame_drawer.hpp"

#include "validation.hpp"

#include <cmath>

namespace prelight::app {
namespace {

/// What a moment's motion is measured over, as `render` has it.
constexpr double motion_interval = Moment{}.interval;

} // namespace

FrameDrawer::FrameDrawer(const SequenceCommand& command, const SequenceFiles& files, Session& session,
                         SceneAtTime& scene)
    : command_(command), files_(files), session_(session), scene_(scene) {
    const PlacedCamera& start = camera();
    if (command.sequence.turntable)
        turntable_.emplace(scene.start(), start, *command.sequence.turntable,
                           command.render.framing || !has_camera(scene.scene()));
}

void FrameDrawer::draw(const FrameNumbers& frames, FrameWriter& writer) {
    const FrameRate& rate = command_.sequence.rate;
    Stopwatch watch;
    for (size_t i = 0; i < frames.size(); ++i) {
        const double time = rate.time_of(frames[i]);
        const World& world = scene_.show(time_of(frames[i]), *session_.renderer);
        if (i + 1 < frames.size()) // the host's part of the next frame, while the device draws this one
            scene_.prepare(time_of(frames[i + 1]));
        session_.renderer->render(turntable_ ? turntable_->at(time, motion_interval) : camera());
        figures_.stats.add(session_.renderer->stats());
        DrawnFrame frame = read(frames[i]);
        if (session_.device)
            check_validation(*session_.device);
        if (i == 0)
            tell(frame, world);
        writer.push(std::move(frame));
        const double lap = watch.lap();
        if (i > 0) // the first makes pipelines
            figures_.interval_ms.push_back(lap);
    }
}

double FrameDrawer::time_of(uint32_t frame) const {
    const double time = command_.sequence.rate.time_of(frame);
    return command_.sequence.loop ? std::fmod(time, *scene_.length()) : time;
}

DrawnFrame FrameDrawer::read(uint32_t number) {
    DrawnFrame frame{number, read_pictures(*session_.renderer, command_.render)};
    const std::vector<std::filesystem::path> names = files_.at(number);
    for (size_t p = 0; p < names.size(); ++p)
        frame.pictures[p].file = names[p];
    return frame;
}

/// What `render` tells of its picture, of the first frame only.
void FrameDrawer::tell(const DrawnFrame& frame, const World& world) const {
    const Log log(command_.render.reading.log_level);
    for (const std::string& note : figures_.stats.all().notes)
        log.note(note);
    warn_of_picture(command_.render, frame.pictures[0], world);
}

} // namespace prelight::app
