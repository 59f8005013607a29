#include "map_levels.hpp"
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <image/srgb_codes.hpp>

namespace prelight::resident {
namespace {

Image decoded(const TextureImage& image, uint32_t left, uint32_t width) {
    Image out(width, image.height);
    const std::array<float, 256>& linear = srgb_linear();
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const uint8_t* code = &image.rgba[(size_t(y) * image.width + left + x) * 4];
            out.pixels[size_t(y) * width + x] = {linear[code[0]], linear[code[1]], linear[code[2]]};
        }
    return out;
}

/// Which texels of `from` one of `to` covers, and how much of each.
struct Share {
    uint32_t texel;
    double weight;
};
std::vector<std::vector<Share>> shares(uint32_t from, uint32_t to) {
    std::vector<std::vector<Share>> out(to);
    const double step = double(from) / to;
    for (uint32_t i = 0; i < to; ++i) {
        const double low = i * step, high = (i + 1) * step;
        for (auto t = static_cast<uint32_t>(low); t < from && t < high; ++t)
            if (const double weight = std::min(high, t + 1.0) - std::max(low, double(t)); weight > 1e-9 * step)
                out[i].push_back({t, weight / step});
    }
    return out;
}

/// Area means: first along rows, then along columns.
Image shrunk(const Image& image, uint32_t width, uint32_t height) {
    const auto across = shares(image.width, width), down = shares(image.height, height);
    Image narrow(width, image.height), out(width, height);
    const auto sum = [](const std::vector<Share>& parts, auto texel) {
        glm::dvec3 total(0);
        for (const Share& part : parts)
            total += part.weight * glm::dvec3(texel(part.texel));
        return glm::vec3(total);
    };
    for (size_t y = 0; y < image.height; ++y)
        for (size_t x = 0; x < width; ++x)
            narrow.pixels[y * width + x] = sum(across[x], [&](size_t u) { return image.pixels[y * image.width + u]; });
    for (size_t y = 0; y < height; ++y)
        for (size_t x = 0; x < width; ++x)
            out.pixels[y * width + x] = sum(down[y], [&](size_t v) { return narrow.pixels[v * width + x]; });
    return out;
}

std::vector<Image> levels_of(const Image& whole) {
    std::vector<Image> levels{whole};
    for (uint32_t k = 1; k < level_count(whole.width, whole.height); ++k)
        levels.push_back(shrunk(whole, std::max(1u, whole.width >> k), std::max(1u, whole.height >> k)));
    return levels;
}

/// `beyond(x, y)`: the texel at a place that may be one outside of `level`.
template <class Beyond>
EdgedLevel edged(const Image& level, Beyond beyond) {
    const auto width = static_cast<int>(level.width), height = static_cast<int>(level.height);
    EdgedLevel out(level.width + 2, level.height + 2);
    for (int y = -1; y <= height; ++y)
        for (int x = -1; x <= width; ++x)
            out.pixels[size_t(y + 1) * out.width + size_t(x + 1)] = beyond(x, y);
    return out;
}

glm::vec3 texel_at(const Image& level, int x, int y) { return level.pixels[size_t(y) * level.width + size_t(x)]; }

EdgedLevel edged_flat(const Image& level, bool wraps) {
    const auto width = static_cast<int>(level.width), height = static_cast<int>(level.height);
    return edged(level, [&](int x, int y) {
        return texel_at(level, wraps ? (x + width) % width : std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1));
    });
}

/// The direction through a place of a cube's face, −1 … 1 to the right and down; faces as the light sees them.
glm::dvec3 through(int face, double right, double down) {
    switch (face) {
    case 0: return {1, -down, right};
    case 1: return {-1, -down, -right};
    case 2: return {right, 1, -down};
    case 3: return {right, -1, down};
    case 4: return {-right, -down, 1};
    default: return {right, -down, -1};
    }
}

/// The texel of one of the six levels that a direction meets.
glm::vec3 met(const std::array<const Image*, 6>& faces, glm::dvec3 d) {
    const glm::dvec3 size(std::abs(d.x), std::abs(d.y), std::abs(d.z));
    int face;
    double right, down, away;
    if (size.x >= size.y && size.x >= size.z) {
        face = d.x < 0 ? 1 : 0;
        away = size.x, right = d.x < 0 ? -d.z : d.z, down = -d.y;
    } else if (size.y >= size.z) {
        face = d.y < 0 ? 3 : 2;
        away = size.y, right = d.x, down = d.y < 0 ? d.z : -d.z;
    } else {
        face = d.z < 0 ? 5 : 4;
        away = size.z, right = d.z < 0 ? d.x : -d.x, down = -d.y;
    }
    const Image& level = *faces[size_t(face)];
    const auto side = static_cast<int>(level.width);
    const auto index = [&](double place) {
        return std::clamp(int(std::floor((place / away + 1) / 2 * side)), 0, side - 1);
    };
    return texel_at(level, index(right), index(down));
}

/// Past a corner three faces meet: the mean of their texels there.
EdgedLevel edged_face(const std::array<const Image*, 6>& faces, int face) {
    const Image& level = *faces[size_t(face)];
    const auto side = static_cast<int>(level.width);
    const auto place = [&](int i) { return 2 * (i + 0.5) / side - 1; };
    return edged(level, [&](int x, int y) {
        const int inside_x = std::clamp(x, 0, side - 1), inside_y = std::clamp(y, 0, side - 1);
        const glm::vec3 own = texel_at(level, inside_x, inside_y);
        if (x == inside_x && y == inside_y)
            return own;
        const glm::vec3 beside = met(faces, through(face, place(x), place(inside_y)));
        const glm::vec3 above = met(faces, through(face, place(inside_x), place(y)));
        if (x != inside_x && y != inside_y)
            return (own + beside + above) / 3.0f;
        return x != inside_x ? beside : above;
    });
}

std::vector<EdgedLevel> cube_levels(const TextureImage& image) {
    std::array<std::vector<Image>, 6> faces;
    for (uint32_t face = 0; face < 6; ++face)
        faces[face] = levels_of(decoded(image, face * image.height, image.height));
    std::vector<EdgedLevel> out;
    for (int face = 0; face < 6; ++face)
        for (size_t k = 0; k < faces[0].size(); ++k) {
            std::array<const Image*, 6> beside;
            for (size_t f = 0; f < 6; ++f)
                beside[f] = &faces[f][k];
            out.push_back(edged_face(beside, face));
        }
    return out;
}

/// The least number of even steps over `span` that meets all `offsets`; `most` where none does.
uint32_t even_steps(const std::vector<double>& offsets, double span, uint32_t most) {
    for (uint32_t steps = 1; steps < most; ++steps) {
        const double scale = steps / span;
        if (std::all_of(offsets.begin(), offsets.end(), [&](double offset) {
                return std::abs(offset * scale - std::round(offset * scale)) < 1e-6 * steps;
            }))
            return steps;
    }
    return most;
}

/// Between which two of some ascending angles one lies, and where between them. Of a turn: it goes round.
struct Between {
    size_t low, high;
    double share;
};
Between between(const std::vector<double>& angles, double angle, bool turn) {
    const size_t count = angles.size();
    if (turn && count == 1)
        return {0, 0, 0};
    size_t high = 0;
    while (high < count && angles[high] <= angle)
        ++high;
    if (!turn)
        high = std::clamp<size_t>(high, 1, count - 1);
    const size_t low = (high + count - 1) % count;
    const double from = high == 0 ? angles[low] - 360 : angles[low],
                 to = high == count ? angles[0] + 360 : angles[high];
    return {low, high % count, std::clamp((angle - from) / (to - from), 0.0, 1.0)};
}

} // namespace

uint32_t level_count(uint32_t width, uint32_t height) {
    return static_cast<uint32_t>(std::bit_width(std::max(width, height)));
}

std::vector<EdgedLevel> cookie_levels(const TextureImage& image, CookieKind kind) {
    if (kind == CookieKind::cube)
        return cube_levels(image);
    std::vector<EdgedLevel> out;
    for (const Image& level : levels_of(decoded(image, 0, image.width)))
        out.push_back(edged_flat(level, kind == CookieKind::sphere));
    return out;
}

EdgedLevel profile_level(const LightProfile& profile) {
    std::vector<double> down;
    const double first = profile.vertical.front(), span = profile.vertical.back() - first;
    for (const double angle : profile.vertical)
        down.push_back(angle - first);
    const bool round = profile.horizontal.size() == 1;
    const uint32_t columns = round ? 1 : even_steps(profile.horizontal, 360, 1440);
    const uint32_t rows = even_steps(down, span, 720) + 1;
    Image level(columns, rows);
    const auto value = [&](size_t column, size_t row) {
        return profile.candela[column * profile.vertical.size() + row];
    };
    for (uint32_t y = 0; y < rows; ++y)
        for (uint32_t x = 0; x < columns; ++x) {
            const Between v = between(profile.vertical, first + span * y / (rows - 1), false);
            const Between h = between(profile.horizontal, 360.0 * x / columns, true);
            const double low = value(h.low, v.low) * (1 - v.share) + value(h.low, v.high) * v.share;
            const double high = value(h.high, v.low) * (1 - v.share) + value(h.high, v.high) * v.share;
            level.pixels[size_t(y) * columns + x] = glm::vec3((low * (1 - h.share) + high * h.share) / profile.largest);
        }
    return edged_flat(level, true);
}

} // namespace prelight::resident
