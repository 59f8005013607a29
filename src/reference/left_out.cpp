#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <prelight/reference.hpp>

namespace prelight {
namespace {

constexpr uint32_t background = 0xffffffffu;
constexpr double cos_30_degrees = 0.86602540378443865;
constexpr double plane_share = 0.01; ///< of depth

/// Whether pixel `a`, beside pixel `b`, cannot be expected to be exact. Not symmetric: each pixel
/// measures its neighbour by its own plane and depth.
bool edge(const ReferencePicture& picture, size_t a, size_t b) {
    if (picture.instance[a] != picture.instance[b] || picture.shadow_mask[a] != picture.shadow_mask[b] ||
        picture.mask_outcome[a] != picture.mask_outcome[b])
        return true;
    if (picture.instance[a] == background)
        return false;
    if (glm::dot(picture.normal[a], picture.normal[b]) < cos_30_degrees)
        return true;
    const double off_plane = std::abs(glm::dot(picture.position[b] - picture.position[a], picture.geometric_normal[a]));
    return off_plane > plane_share * picture.depth[a];
}

} // namespace

std::vector<uint8_t> ReferencePicture::left_out() const {
    std::vector<uint8_t> result(linear.pixels.size(), 0);
    const auto width = static_cast<int64_t>(linear.width);
    const auto height = static_cast<int64_t>(linear.height);
    for (int64_t y = 0; y < height; ++y)
        for (int64_t x = 0; x < width; ++x) {
            const auto self = static_cast<size_t>(y * width + x);
            for (int64_t v = std::max<int64_t>(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
                for (int64_t u = std::max<int64_t>(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
                    if (edge(*this, self, static_cast<size_t>(v * width + u)))
                        result[self] = 1;
        }
    return result;
}

} // namespace prelight
