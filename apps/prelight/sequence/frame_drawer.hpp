#pragma once
#include "sequence/frame_writer.hpp"
#include "sequence/plan.hpp"
#include "sequence/scene_at_time.hpp"
#include "sequence/sequence_json.hpp"
#include "sequence/turntable.hpp"

namespace prelight::app {

/// Draws frame after frame and hands each on to be written. What it is given must outlive it.
class FrameDrawer {
public:
    /// Throws UsageError for a camera that is not there.
    FrameDrawer(const SequenceCommand& command, const SequenceFiles& files, Session& session, SceneAtTime& scene);

    /// The command's camera at the moment that was drawn last, before the first at time 0.
    const PlacedCamera& camera() const { return scene_.camera(command_.render.camera); }
    /// Throws Error, also what `writer` failed with.
    void draw(const FrameNumbers& frames, FrameWriter& writer);
    /// Of what has been drawn.
    SequenceFigures& figures() { return figures_; }

private:
    /// Of the scene, at a frame: with --loop, from the animations' last beginning on.
    double time_of(uint32_t frame) const;
    DrawnFrame read(uint32_t number);
    void tell(const DrawnFrame& frame, const World& world) const;

    const SequenceCommand& command_;
    const SequenceFiles& files_;
    Session& session_;
    SceneAtTime& scene_;
    std::optional<Turntable> turntable_;
    SequenceFigures figures_;
};

} // namespace prelight::app
