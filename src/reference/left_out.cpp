#include <algorithm>
#include <prelight/reference.hpp>
#include <reference/same_surface.hpp>

namespace prelight {
namespace {

constexpr uint32_t background = 0xffffffffu;

/// Where each pixel's layers begin in ReferencePicture::layers, and where the last ones end; empty: there are none.
std::vector<size_t> layer_places(const ReferencePicture& picture) {
    std::vector<size_t> places;
    if (!picture.layer_count.empty())
        places.push_back(0);
    for (const uint32_t count : picture.layer_count)
        places.push_back(places.back() + count);
    return places;
}

/// The same as for what is opaque, of the layers of two pixels: one by one from the nearest.
bool crosses_layer_edge(const ReferencePicture& picture, const std::vector<size_t>& places, size_t a, size_t b) {
    if (places.empty() || a == b)
        return false;
    if (picture.layer_count[a] != picture.layer_count[b])
        return true;
    for (uint32_t i = 0; i < picture.layer_count[a]; ++i) {
        const ReferenceLayer& own = picture.layers[places[a] + i];
        const ReferenceLayer& other = picture.layers[places[b] + i];
        if (own.instance != other.instance || own.shadow_mask != other.shadow_mask ||
            !reference::same_direction(own.normal, other.normal) ||
            !reference::same_plane(own.position, own.geometric_normal, own.depth, other.position))
            return true;
    }
    return false;
}

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
    for (size_t i = 0; i < doubts.size(); ++i)
        result[i] = doubts[i] != 0;
    if (samples > 1)
        return result;
    const auto width = static_cast<int64_t>(linear.width);
    const auto height = static_cast<int64_t>(linear.height);
    const std::vector<size_t> places = layer_places(*this);
    for (int64_t y = 0; y < height; ++y)
        for (int64_t x = 0; x < width; ++x) {
            const auto self = static_cast<size_t>(y * width + x);
            for (int64_t v = std::max<int64_t>(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
                for (int64_t u = std::max<int64_t>(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
                    const auto beside = static_cast<size_t>(v * width + u);
                    if (crosses_edge(*this, self, beside) || crosses_layer_edge(*this, places, self, beside))
                        result[self] = 1;
                }
        }
    return result;
}

} // namespace prelight
