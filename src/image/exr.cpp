#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <half.h>
#include <platform/atomic_file.hpp>
#include <platform/read_file.hpp>
#include <platform/spare_memory.hpp>
#include <prelight/error.hpp>
#include <prelight/image.hpp>
#include <stdexcept>

namespace prelight {
namespace {

constexpr const char* channel_names[3] = {"R", "G", "B"};
constexpr float half_max = 65504;

/// OpenEXR goes back to fill in where its lines begin, so that the file grows here before it is written.
class MemoryStream final : public Imf::OStream {
public:
    MemoryStream() : Imf::OStream("picture") {}
    void write(const char bytes[], int count) override {
        const auto size = static_cast<size_t>(count);
        bytes_.resize(std::max(bytes_.size(), at_ + size));
        std::copy_n(bytes, size, bytes_.begin() + static_cast<ptrdiff_t>(at_));
        at_ += size;
    }
    uint64_t tellp() override { return at_; }
    void seekp(uint64_t position) override { at_ = position; }
    const std::vector<char>& bytes() const { return bytes_; }

private:
    std::vector<char> bytes_;
    size_t at_ = 0;
};

/// A file that has been read: OpenEXR would open pipes and devices.
class Bytes : public Imf::IStream {
public:
    Bytes(const char* name, FileBytes bytes) : IStream(name), bytes_(std::move(bytes)) {}
    bool read(char to[], int count) override {
        if (count < 0 || static_cast<uint64_t>(count) > bytes_.size() - at_)
            throw std::runtime_error("it ends too early");
        std::memcpy(to, bytes_.data() + at_, static_cast<size_t>(count));
        at_ += static_cast<uint64_t>(count);
        return at_ < bytes_.size();
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t to) override { at_ = std::min<uint64_t>(to, bytes_.size()); }

private:
    FileBytes bytes_;
    uint64_t at_ = 0;
};

} // namespace

void save_exr(const Image& linear, const std::filesystem::path& path) {
    AtomicFile file(path);
    if (linear.width == 0 || linear.height == 0)
        throw Error(
            fmt::format("{}: a picture of {}x{} pixels cannot be written", path.string(), linear.width, linear.height));
    std::vector<Imath::half> halves;
    halves.reserve(linear.pixels.size() * 3);
    for (const glm::vec3& pixel : linear.pixels)
        for (int channel = 0; channel < 3; ++channel)
            halves.push_back(Imath::half(std::clamp(pixel[channel], -half_max, half_max)));
    MemoryStream stream;
    try {
        Imf::Header header(static_cast<int>(linear.width), static_cast<int>(linear.height));
        header.compression() = Imf::ZIP_COMPRESSION;
        Imf::FrameBuffer buffer;
        for (size_t channel = 0; channel < 3; ++channel) {
            header.channels().insert(channel_names[channel], Imf::Channel(Imf::HALF));
            buffer.insert(channel_names[channel],
                          Imf::Slice(Imf::HALF, reinterpret_cast<char*>(halves.data() + channel),
                                     3 * sizeof(Imath::half), 3 * sizeof(Imath::half) * linear.width));
        }
        Imf::OutputFile output(stream, header, 0);
        output.setFrameBuffer(buffer);
        output.writePixels(static_cast<int>(linear.height));
    } catch (const std::exception& error) {
        throw Error(fmt::format("{}: cannot be written as OpenEXR ({})", path.string(), error.what()));
    }
    file.write(stream.bytes().data(), stream.bytes().size());
    file.commit();
}

Image load_exr(const std::filesystem::path& path) try {
    Bytes bytes(path.c_str(), read_file(path, largest_file::environment));
    Imf::InputFile input(bytes, 0);
    const Imath::Box2i window = input.header().dataWindow();
    const int64_t width = int64_t(window.max.x) - window.min.x + 1;
    const int64_t height = int64_t(window.max.y) - window.min.y + 1;
    if (width < 1 || height < 1 || width > 65536 || height > 65536 || width * height > (int64_t(1) << 28))
        throw Error(fmt::format("{}: a picture of {}x{} pixels is not read", path.string(), width, height));
    if (static_cast<uint64_t>(width * height) * sizeof(glm::vec3) > spare_memory())
        throw Error(fmt::format("{}: {}x{} pixels need more memory than there is", path.string(), width, height));
    Image image(static_cast<uint32_t>(width), static_cast<uint32_t>(height));
    // OpenEXR addresses pixel (x, y) from the frame buffer's base, whatever the window's origin is.
    const int64_t origin = window.min.x + window.min.y * width;
    auto* base = reinterpret_cast<char*>(image.pixels.data()) - origin * static_cast<int64_t>(sizeof(glm::vec3));
    Imf::FrameBuffer buffer;
    for (size_t channel = 0; channel < 3; ++channel) {
        if (!input.header().channels().findChannel(channel_names[channel]))
            throw Error(fmt::format("{}: channel {} is missing", path.string(), channel_names[channel]));
        buffer.insert(channel_names[channel], Imf::Slice(Imf::FLOAT, base + channel * sizeof(float), sizeof(glm::vec3),
                                                         sizeof(glm::vec3) * image.width));
    }
    input.setFrameBuffer(buffer);
    input.readPixels(window.min.y, window.max.y);
    return image;
} catch (const Error&) {
    throw;
} catch (const std::exception& error) {
    throw Error(fmt::format("{}: not a readable OpenEXR file ({})", path.string(), error.what()));
}

} // namespace prelight
