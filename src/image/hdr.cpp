// Radiance's picture format (Ward, "Real Pixels", Graphics Gems II, 1991; filefmts.pdf of Radiance).
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <platform/read_file.hpp>
#include <platform/spare_memory.hpp>
#include <prelight/error.hpp>
#include <prelight/image.hpp>
#include <string_view>

namespace prelight {
namespace {

constexpr uint32_t most = 65536; ///< pixels of a side

using Code = std::array<uint8_t, 4>; ///< three mantissas and a shared exponent

class Reader {
public:
    Reader(std::string file, std::string bytes) : file_(std::move(file)), bytes_(std::move(bytes)) {}

    Image read() {
        const double scale = read_header();
        const auto [width, height] = read_size();
        // A row takes at least two bytes for each channel and 127 pixels.
        if (uint64_t(width) * height / 32 > bytes_.size())
            fail("ends too early");
        if (uint64_t(width) * height * sizeof(glm::vec3) > spare_memory())
            fail(fmt::format("{}x{} pixels need more memory than there is", width, height));
        Image image(width, height);
        std::vector<Code> row(width);
        for (uint32_t y = 0; y < height; ++y) {
            read_row(row);
            for (uint32_t x = 0; x < width; ++x)
                image.at(x, y) = radiance(row[x], scale);
        }
        return image;
    }

private:
    [[noreturn]] void fail(std::string_view reason) const { throw Error(fmt::format("{}: {}", file_, reason)); }

    uint8_t byte() {
        if (at_ >= bytes_.size())
            fail("ends too early");
        return static_cast<uint8_t>(bytes_[at_++]);
    }

    std::string_view line() {
        const size_t end = bytes_.find('\n', at_);
        if (end == std::string::npos || end - at_ > 4096)
            fail("not a Radiance picture");
        std::string_view text(bytes_.data() + at_, end - at_);
        at_ = end + 1;
        return text;
    }

    /// Returns what values are divided by.
    double read_header() {
        if (!line().starts_with("#?"))
            fail("not a Radiance picture");
        double scale = 1;
        for (std::string_view text = line(); !text.empty(); text = line()) {
            if (text.starts_with("FORMAT=") && text != "FORMAT=32-bit_rle_rgbe")
                fail("its pixels are not RGBE");
            if (!text.starts_with("EXPOSURE="))
                continue;
            text.remove_prefix(9);
            text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
            double value = 0;
            const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
            if (read.ec != std::errc() || !(value > 1e-9 && value < 1e9))
                fail("its EXPOSURE is no number above 0");
            scale *= value;
        }
        return scale;
    }

    /// "-Y HEIGHT +X WIDTH": rows from the top, from left to right.
    std::pair<uint32_t, uint32_t> read_size() {
        const std::string_view text = line();
        const size_t middle = text.find(" +X ");
        uint32_t width = 0, height = 0;
        const auto number = [&](std::string_view digits, uint32_t& value) {
            const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value);
            return read.ec == std::errc() && read.ptr == digits.data() + digits.size() && value >= 1 && value <= most;
        };
        if (!text.starts_with("-Y ") || middle == std::string_view::npos ||
            !number(text.substr(3, middle - 3), height) || !number(text.substr(middle + 4), width) ||
            uint64_t(width) * height > uint64_t(1) << 28)
            fail("a size as this is not read (expected: -Y HEIGHT +X WIDTH)");
        return {width, height};
    }

    void read_row(std::vector<Code>& row) {
        const Code first{byte(), byte(), byte(), byte()};
        const size_t width = row.size();
        if (first[0] != 2 || first[1] != 2 || first[2] >= 128 || width < 8 || width > 32767) {
            read_flat(row, first);
            return;
        }
        if (size_t(first[2]) << 8 != (width & ~size_t(255)) || first[3] != (width & 255))
            fail("a row is not as wide as the picture");
        for (size_t channel = 0; channel < 4; ++channel)
            for (size_t x = 0; x < width;) {
                const uint8_t count = byte();
                const size_t run = count > 128 ? count - 128u : count;
                if (run == 0 || run > width - x)
                    fail("a row is not as wide as the picture");
                uint8_t value = count > 128 ? byte() : 0;
                for (size_t i = 0; i < run; ++i)
                    row[x++][channel] = count > 128 ? value : byte();
            }
    }

    /// Pixel by pixel; 1 1 1 N repeats the one before N times (its first encoding).
    void read_flat(std::vector<Code>& row, Code code) {
        uint32_t shift = 0;
        for (size_t x = 0; x < row.size();) {
            if (x > 0 || shift > 0)
                code = {byte(), byte(), byte(), byte()};
            if (code[0] == 1 && code[1] == 1 && code[2] == 1 && x > 0 && shift < 32) {
                const uint64_t run = uint64_t(code[3]) << shift;
                if (run > row.size() - x)
                    fail("a row is not as wide as the picture");
                for (uint64_t i = 0; i < run; ++i, ++x)
                    row[x] = row[x - 1];
                shift += 8;
                continue;
            }
            row[x++] = code;
            shift = 0;
        }
    }

    static glm::vec3 radiance(const Code& code, double scale) {
        if (code[3] == 0)
            return glm::vec3(0);
        const double factor = std::ldexp(1.0, code[3] - 128 - 8) / scale;
        return glm::vec3(float(code[0] * factor), float(code[1] * factor), float(code[2] * factor));
    }

    std::string file_, bytes_;
    size_t at_ = 0;
};

} // namespace

Image load_hdr(const std::filesystem::path& path) {
    return Reader(path.string(), read_text_file(path, largest_file::environment)).read();
}

} // namespace prelight
