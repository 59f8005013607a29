#pragma once
#include "sequence/frame_rate.hpp"

#include <memory>
#include <platform/atomic_file.hpp>
#include <platform/program/child_process.hpp>
#include <prelight/image.hpp>

namespace prelight::app {

/// True for the names of files that Video writes: .mp4, .mkv.
bool is_video(const std::filesystem::path& file);

/// A video file that ffmpeg encodes from raw frames, and that appears whole or not at all.
/// .mkv: FFV1, from which ffmpeg decodes the very bytes that the PNGs would have.
/// .mp4: H.264, 4:2:0, tagged as BT.709 with the transfer function of sRGB; even sizes only.
class Video {
public:
    /// Starts ffmpeg. Throws Error.
    Video(const std::filesystem::path& file, uint32_t width, uint32_t height, const FrameRate& rate);
    /// The next frame, as save_png() would write it. Throws Error, also where ffmpeg has given up.
    void add(const Image& display);
    /// Waits for ffmpeg; the file is there then. Throws Error when its exit status is not 0.
    void finish();

private:
    std::filesystem::path name_;
    AtomicFile file_;
    std::unique_ptr<ChildProcess> ffmpeg_;
};

} // namespace prelight::app
