#pragma once
#include "command_line.hpp"
#include "sequence/numbered_name.hpp"

namespace prelight::app {

/// The files of a sequence: the picture's, then those of --view BUFFER=FILE, as numbered names.
class SequenceFiles {
public:
    /// Throws UsageError: an ending that does not suit the content, a name that is no pattern.
    explicit SequenceFiles(const RenderCommand& command);

    bool video() const { return video_; }
    /// Of a frame, as read_pictures() orders its pictures; a video's own file is the same for all.
    std::vector<std::filesystem::path> at(uint32_t frame) const;
    /// Throws UsageError where several frames would be written to one name.
    void check_numbered(size_t frames) const;
    /// Throws UsageError where two of the frames' files are one, or one is among `inputs`.
    void check_frames(const FrameNumbers& frames, const std::filesystem::path& stats,
                      const std::vector<std::filesystem::path>& inputs) const;
    /// True when each of the frame's files is a picture of that size that can be read to its end.
    bool are_whole(uint32_t frame, uint32_t width, uint32_t height) const;

private:
    bool video_ = false;
    std::vector<NumberedName> names_;
};

/// What can be told without the scene. Throws UsageError.
void check_sequence(const SequenceCommand& command);

/// What there is to draw.
struct SequencePlan {
    FrameNumbers wanted;   ///< of this task
    FrameNumbers to_draw;  ///< of these, what is not there
    FrameNumbers existing; ///< of these, the rest
};

/// How many frames the sequence has by itself: one round of the turntable, or else the loop, or else the
/// animations up to their last keyframe. Absent: it has neither. `length`: of the animations, seconds.
std::optional<uint32_t> frames_in(const SequenceOptions& options, std::optional<double> length);

/// The frames of the list, which all tasks share. `endless`: the scene goes on moving after its animations' end. Throws
/// UsageError, naming `scene`, when nothing says how many there are, or none is left.
FrameNumbers all_frames(const SequenceOptions& options, const std::string& scene, std::optional<double> length,
                        bool endless);

/// `all` less what other tasks draw and what is there.
SequencePlan plan_frames(const SequenceCommand& command, const SequenceFiles& files, const FrameNumbers& all);

} // namespace prelight::app
