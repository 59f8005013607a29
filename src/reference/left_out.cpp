#include <algorithm>
#include <prelight/reference.hpp>
#include <reference/same_surface.hpp>

namespace prelight {
namespace {

constexpr uint32_t background = 0xffffffffu;

/// Whether pixel `a`, beside pixel `b`, cannot be expected to be exact. Not symmetric: each pixel
/// measures its neighbour by its own plane and depth.
bool crosses_edge(const ReferencePicture& picture, size_t a, size_t b) {
    if (picture.instance[a] != picture.instance[b] || picture.shadow_mask[a] != picture.shadow_mask[b] ||
        picture.mask_outcome[a] != picture.mask_outcome[b])
        return true;
    if (picture.instance[a] == background)
        return false;
    return !reference::same_direction(picture.normal[a], picture.normal[b]) ||
           !reference::same_plane(picture.position[a], picture.geometric_normal[a], picture.depth[a],
                                  picture.position[b]);
}

} // namespace

std::vector<uint8_t> ReferencePicture::left_out() const {
    std::vector<uint8_t> result(linear.pixels.size(), 0);
    if (samples > 1) {
        for (size_t i = 0; i < result.size(); ++i)
            result[i] = doubts[i] != 0;
        return result;
    }
    const auto width = static_cast<int64_t>(linear.width);
    const auto height = static_cast<int64_t>(linear.height);
    for (int64_t y = 0; y < height; ++y)
        for (int64_t x = 0; x < width; ++x) {
            const auto self = static_cast<size_t>(y * width + x);
            for (int64_t v = std::max<int64_t>(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
                for (int64_t u = std::max<int64_t>(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
                    if (crosses_edge(*this, self, static_cast<size_t>(v * width + u)))
                        result[self] = 1;
        }
    return result;
}

} // namespace prelight
