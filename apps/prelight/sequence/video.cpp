#include "sequence/video.hpp"

#include "argument.hpp"

#include <fmt/format.h>
#include <image/display_bytes.hpp>
#include <platform/program/interrupt.hpp>
#include <prelight/error.hpp>

namespace prelight::app {
namespace {

using Words = std::vector<std::string>;

/// The output's part. The format is named, for the file's temporary name says nothing; bitexact: no random numbers
/// and no version in the file, so that two runs give the same bytes.
Words encoder_of(const std::filesystem::path& file) {
    if (lower_extension(file) == ".mkv")
        return {"-c:v",
                "ffv1",
                "-level",
                "3",
                "-g",
                "1",
                "-slicecrc",
                "1",
                "-pix_fmt",
                "bgr0",
                "-color_range",
                "pc",
                "-color_primaries",
                "bt709",
                "-color_trc",
                "iec61966-2-1",
                "-f",
                "matroska"};
    return {"-vf",
            "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p",
            "-c:v",
            "libx264",
            "-preset",
            "medium",
            "-crf",
            "16",
            "-color_range",
            "tv",
            "-colorspace",
            "bt709",
            "-color_primaries",
            "bt709",
            "-color_trc",
            "iec61966-2-1",
            "-movflags",
            "+faststart",
            "-f",
            "mp4"};
}

Words ffmpeg_arguments(const std::filesystem::path& file, uint32_t width, uint32_t height, const FrameRate& rate) {
    Words words{
        "ffmpeg",     "-hide_banner", "-nostdin", "-loglevel", "error",       "-y",
        "-f",         "rawvideo",     "-pix_fmt", "rgb24",     "-video_size", fmt::format("{}x{}", width, height),
        "-framerate", rate.text,      "-i",       "pipe:0",    "-an"};
    const Words encoder = encoder_of(file);
    words.insert(words.end(), encoder.begin(), encoder.end());
    // Under its number and not its name: an interrupt takes the name away, and a late ffmpeg would make it anew.
    words.insert(words.end(), {"-fflags", "+bitexact", "-flags:v", "+bitexact", ChildProcess::output_name});
    return words;
}

/// What goes wrong with ffmpeg goes wrong with the file.
template <class Work>
void named(const std::filesystem::path& file, const Work& work) {
    try {
        work();
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}", file.string(), error.what()));
    }
}

} // namespace

bool is_video(const std::filesystem::path& file) {
    const std::string extension = lower_extension(file);
    return extension == ".mp4" || extension == ".mkv";
}

Video::Video(const std::filesystem::path& file, uint32_t width, uint32_t height, const FrameRate& rate)
    : name_(file), file_(file) {
    if (file_.temporary().empty())
        throw Error(fmt::format("{}: a video needs a file: parts of it are written twice", name_.string()));
    named(name_, [&] {
        ffmpeg_ = std::make_unique<ChildProcess>(ffmpeg_arguments(file, width, height, rate), file_.temporary());
    });
}

void Video::add(const Image& display) {
    named(name_, [&] { ffmpeg_->write(display_bytes(display)); });
}

void Video::finish() {
    named(name_, [&] { ffmpeg_->finish(); });
    const WriteGuard guard;
    file_.commit();
}

} // namespace prelight::app
