#include "sequence/plan.hpp"

#include "argument.hpp"
#include "output.hpp"
#include "sequence/video.hpp"

#include <algorithm>
#include <cmath>
#include <parallel/parallel_for.hpp>

namespace prelight::app {
namespace {

constexpr double latest_time = 1e6; ///< seconds, as of --time

/// Read to its end: a file that was cut short, is empty or has a wrong checksum is none.
bool is_whole(const std::filesystem::path& file, uint32_t width, uint32_t height) {
    std::error_code missing;
    if (!std::filesystem::is_regular_file(file, missing))
        return false;
    try {
        const Image image = lower_extension(file) == ".exr" ? load_exr(file) : load_png(file);
        return image.width == width && image.height == height;
    } catch (const Error&) {
        return false;
    }
}

} // namespace

SequenceFiles::SequenceFiles(const RenderCommand& command) : video_(is_video(command.output)) {
    names_.emplace_back("-o", command.output);
    if (video_ && names_[0].numbered())
        throw UsageError(fmt::format("-o {}: a video is one file: its name has no #", command.output.string()));
    for (const ViewFile& more : command.more_views)
        names_.emplace_back("--view", more.file);
}

std::vector<std::filesystem::path> SequenceFiles::at(uint32_t frame) const {
    std::vector<std::filesystem::path> files;
    for (const NumberedName& name : names_)
        files.push_back(name.at(frame));
    return files;
}

void SequenceFiles::check_numbered(size_t frames) const {
    for (size_t i = video_ ? 1 : 0; i < names_.size() && frames > 1; ++i)
        if (!names_[i].numbered())
            throw UsageError(fmt::format("{} {}: {} frames need a # for their numbers, as in {}",
                                         i == 0 ? "-o" : "--view", names_[i].pattern().string(), frames,
                                         (names_[i].pattern().parent_path() / names_[i].pattern().stem()).string() +
                                             ".####" + names_[i].pattern().extension().string()));
}

void SequenceFiles::check_frames(const FrameNumbers& frames, const std::filesystem::path& stats,
                                 const std::vector<std::filesystem::path>& inputs) const {
    std::vector<std::filesystem::path> outputs{stats};
    for (const uint32_t frame : frames)
        for (std::filesystem::path& file : at(frame))
            if (outputs.size() < 2 || !video_ || file != names_[0].pattern())
                outputs.push_back(std::move(file));
    check_distinct(outputs, inputs);
}

bool SequenceFiles::are_whole(uint32_t frame, uint32_t width, uint32_t height) const {
    return std::ranges::all_of(at(frame), [&](const auto& file) { return is_whole(file, width, height); });
}

void check_sequence(const SequenceCommand& command) {
    const RenderCommand& render = command.render;
    check_endings(render, true);
    if (!SequenceFiles(render).video())
        return;
    const std::string name = render.output.string();
    for (const auto& [given, option] : {std::pair(command.sequence.shard.has_value(), "--shard"),
                                        std::pair(command.sequence.skip_existing, "--skip-existing")})
        if (given)
            throw UsageError(fmt::format("{}: not with {}: a video is one file that one run writes whole; write "
                                         "pictures, as in {}.####.png",
                                         option, name, (render.output.parent_path() / render.output.stem()).string()));
    if (lower_extension(render.output) == ".mp4" && (render.options.width % 2 || render.options.height % 2))
        throw UsageError(fmt::format("--size {}x{}: an .mp4 has even numbers of pixels", render.options.width,
                                     render.options.height));
}

std::optional<uint32_t> frames_in(const SequenceOptions& options, std::optional<double> length) {
    const std::optional<double> seconds = options.turntable ? options.turntable : options.loop ? options.loop : length;
    if (!seconds)
        return {};
    // A round that is no whole number of frames is rounded; animations are shown to their end. Keyframes are floats,
    // whose 2.0000001 s are no frame more.
    const double exact = *seconds * options.rate.per_second();
    const double frames = std::max(options.turntable ? std::round(exact) : std::ceil(exact - 1e-4), 1.0);
    if (frames > most_frames)
        throw UsageError(fmt::format("--fps {}: {:.0f} frames, at most {} can be drawn: say which with --frames-at",
                                     options.rate.text, frames, most_frames));
    return static_cast<uint32_t>(frames);
}

FrameNumbers all_frames(const SequenceOptions& options, const std::string& scene, std::optional<double> length,
                        bool endless) {
    FrameNumbers frames;
    if (options.loop && !length.value_or(0))
        throw UsageError(fmt::format("--loop: {} has no animation that could begin again", scene));
    if (options.frames.empty()) {
        const std::optional<uint32_t> count = frames_in(options, length);
        if (!count)
            throw UsageError(fmt::format("{}: has no animation that says how long the sequence is: say which frames "
                                         "with --frames-at, or --turntable SECONDS",
                                         scene));
        frames = frames_of({{.first = 0, .last = *count - 1}});
    } else if (endless && !options.turntable) {
        frames = frames_of(options.frames);
    } else {
        const std::optional<uint32_t> count = frames_in(options, length);
        frames = frames_of(options.frames, count.value_or(last_frame_number + 1));
        if (frames.empty())
            throw UsageError(fmt::format("--frames-at {}: the sequence has frames 0 to {}", options.frames_text,
                                         count.value_or(1) - 1));
    }
    const uint32_t last = *std::ranges::max_element(frames);
    if (options.rate.time_of(last) > latest_time)
        throw UsageError(
            fmt::format("--frames-at {}: frame {} is later than {} s", options.frames_text, last, latest_time));
    return frames;
}

SequencePlan plan_frames(const SequenceCommand& command, const SequenceFiles& files, const FrameNumbers& all) {
    SequencePlan plan;
    plan.wanted = command.sequence.shard ? shard_of(all, *command.sequence.shard) : all;
    if (!command.sequence.skip_existing) {
        plan.to_draw = plan.wanted;
        return plan;
    }
    std::vector<uint8_t> whole(plan.wanted.size()); // threads write side by side: no bits
    const RenderOptions& options = command.render.options;
    parallel_for(static_cast<uint32_t>(whole.size()),
                 [&](uint32_t i) { whole[i] = files.are_whole(plan.wanted[i], options.width, options.height); });
    for (size_t i = 0; i < whole.size(); ++i)
        (whole[i] ? plan.existing : plan.to_draw).push_back(plan.wanted[i]);
    return plan;
}

} // namespace prelight::app
