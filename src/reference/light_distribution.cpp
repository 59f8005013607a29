#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <prelight/light_distribution.hpp>
#include <reference/light_distribution.hpp>
#include <reference/texture.hpp>

namespace prelight::reference {
namespace {

using std::numbers::pi;

/// How much of texel `texel` of `from` texels lies in texel `cell` of `to`, in texels of `from`.
double overlap(int64_t texel, int64_t from, int64_t cell, int64_t to) {
    const double low = static_cast<double>(cell * from) / static_cast<double>(to);
    const double high = static_cast<double>((cell + 1) * from) / static_cast<double>(to);
    return std::max(0.0, std::min(high, texel + 1.0) - std::max(low, double(texel)));
}

Pyramid::Level shrunk(const Pyramid::Level& whole, int64_t width, int64_t height) {
    Pyramid::Level level{width, height, {}};
    for (int64_t y = 0; y < height; ++y)
        for (int64_t x = 0; x < width; ++x) {
            glm::dvec3 sum(0);
            double weight = 0;
            for (int64_t v = y * whole.height / height; v < whole.height && v * height < (y + 1) * whole.height; ++v)
                for (int64_t u = x * whole.width / width; u < whole.width && u * width < (x + 1) * whole.width; ++u) {
                    const double share = overlap(u, whole.width, x, width) * overlap(v, whole.height, y, height);
                    sum += share * whole.at(u, v);
                    weight += share;
                }
            level.texels.push_back(sum / weight);
        }
    return level;
}

/// Faces of a cube as the light sees them.
struct Face {
    glm::dvec3 axis{0}, right{0}, up{0};
};
const std::array<Face, 6> faces{{{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                 {{-1, 0, 0}, {0, 0, -1}, {0, 1, 0}},
                                 {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                 {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                                 {{0, 0, 1}, {-1, 0, 0}, {0, 1, 0}},
                                 {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}}}};

size_t face_of(glm::dvec3 d) {
    const glm::dvec3 size = glm::abs(d);
    if (size.x >= size.y && size.x >= size.z)
        return d.x < 0 ? 1 : 0;
    if (size.y >= size.z)
        return d.y < 0 ? 3 : 2;
    return d.z < 0 ? 5 : 4;
}

/// Place on a face, 0 … 1 from its left and its top.
glm::dvec2 place_on(const Face& face, glm::dvec3 d) {
    const double away = glm::dot(d, face.axis);
    return {0.5 + 0.5 * glm::dot(d, face.right) / away, 0.5 - 0.5 * glm::dot(d, face.up) / away};
}

/// A texel of a face, or of the face beside it; past a corner, the mean of the three that meet there.
glm::dvec3 cube_texel(const std::vector<Pyramid>& cube, size_t face, size_t level, int64_t x, int64_t y) {
    const Pyramid::Level& own = cube[face].levels[level];
    const int64_t n = own.width, inside_x = std::clamp<int64_t>(x, 0, n - 1),
                  inside_y = std::clamp<int64_t>(y, 0, n - 1);
    if (x == inside_x && y == inside_y)
        return own.at(x, y);
    if (x != inside_x && y != inside_y)
        return (own.at(inside_x, inside_y) + cube_texel(cube, face, level, x, inside_y) +
                cube_texel(cube, face, level, inside_x, y)) /
               3.0;
    const Face& f = faces[face];
    const double across = 2 * (static_cast<double>(x) + 0.5) / static_cast<double>(n) - 1;
    const double down = 2 * (static_cast<double>(y) + 0.5) / static_cast<double>(n) - 1;
    const glm::dvec3 d = f.axis + across * f.right - down * f.up;
    const size_t beside = face_of(d);
    const glm::dvec2 place = place_on(faces[beside], d) * static_cast<double>(n);
    const auto index = [n](double at) { return std::clamp(static_cast<int64_t>(std::floor(at)), int64_t(0), n - 1); };
    return cube[beside].levels[level].at(index(place.x), index(place.y));
}

/// Four texels of a level mixed; `texel` finds them, past the edges too.
template <class Texel>
glm::dvec3 mixed(const Pyramid::Level& level, glm::dvec2 place, Texel texel) {
    const double x = place.x * static_cast<double>(level.width) - 0.5,
                 y = place.y * static_cast<double>(level.height) - 0.5;
    const double left = std::floor(x), top = std::floor(y), s = x - left, t = y - top;
    const auto at = [&](int dx, int dy) {
        return texel(static_cast<int64_t>(left) + dx, static_cast<int64_t>(top) + dy);
    };
    return (1 - t) * ((1 - s) * at(0, 0) + s * at(1, 0)) + t * ((1 - s) * at(0, 1) + s * at(1, 1));
}

/// Between the two levels whose texels are nearest to `texels` of level 0.
template <class Look>
glm::dvec3 between_levels(size_t levels, double texels, Look look) {
    const double lod = std::clamp(std::log2(std::max(texels, 1.0)), 0.0, static_cast<double>(levels - 1));
    const auto level = static_cast<size_t>(lod);
    const double share = lod - static_cast<double>(level);
    const glm::dvec3 finer = look(level);
    return share > 0 ? (1 - share) * finer + share * look(level + 1) : finer;
}

} // namespace

Pyramid::Pyramid(const TextureImage& image, uint32_t left, uint32_t width) {
    Level whole{width, image.height, {}};
    for (size_t y = 0; y < image.height; ++y)
        for (size_t x = left; x < left + width; ++x) {
            const uint8_t* bytes = &image.rgba[(y * image.width + x) * 4];
            whole.texels.emplace_back(linear_of_srgb(bytes[0]), linear_of_srgb(bytes[1]), linear_of_srgb(bytes[2]));
        }
    levels.push_back(std::move(whole));
    while (levels.back().width > 1 || levels.back().height > 1) {
        const auto [w, h, unused] = levels.back();
        levels.push_back(shrunk(levels[0], std::max<int64_t>(1, w / 2), std::max<int64_t>(1, h / 2)));
    }
}

LightDistribution::LightDistribution(const World& world, const PlacedLight& light, Pictures& pictures)
    : axes_(light_axes(light)), kind_(light.light.kind), tangent_(std::tan(double(light.light.outer_cone))),
      profile_(light.light.profile) {
    const uint32_t cookie = light.light.cookie;
    if (cookie == no_cookie)
        return;
    const TextureImage& image = world.scene->images.at(cookie);
    const bool strip = kind_ == LightKind::point && image.width == 6 * image.height;
    // A picture may be a spot's and, as a strip, a point light's: then it is prepared as the faces too.
    auto& known = pictures[2 * cookie + (strip ? 1 : 0)];
    if (!known) {
        std::vector<Pyramid> made;
        for (uint32_t face = 0; face < (strip ? 6u : 1u); ++face)
            made.emplace_back(image, strip ? face * image.height : 0, strip ? image.height : image.width);
        known = std::make_shared<const std::vector<Pyramid>>(std::move(made));
    }
    cookie_ = known;
}

glm::dvec3 LightDistribution::factor(glm::dvec3 direction, double spread) const {
    const glm::dvec3 d = direction * axes_; // dots with the axes: the light's own space
    glm::dvec3 result(1);
    if (cookie_)
        result = kind_ == LightKind::spot ? spot(d, spread)
                 : cookie_->size() == 6   ? cube(d, spread)
                                          : sphere(d, spread);
    return profile_ ? result * profile(d) : result;
}

glm::dvec3 LightDistribution::spot(glm::dvec3 d, double spread) const {
    if (d.z >= 0)
        return glm::dvec3(0);
    const double x = d.x / -d.z, y = d.y / -d.z;
    const glm::dvec2 place(0.5 + 0.5 * x / tangent_, 0.5 - 0.5 * y / tangent_);
    const Pyramid& picture = cookie_->front();
    const double side = static_cast<double>(std::max(picture.levels[0].width, picture.levels[0].height));
    return between_levels(picture.levels.size(), spread * (1 + x * x + y * y) * 0.5 * side / tangent_, [&](size_t k) {
        const Pyramid::Level& level = picture.levels[k];
        return mixed(level, glm::clamp(place, 0.0, 1.0), [&](int64_t u, int64_t v) {
            return level.at(std::clamp<int64_t>(u, 0, level.width - 1), std::clamp<int64_t>(v, 0, level.height - 1));
        });
    });
}

glm::dvec3 LightDistribution::sphere(glm::dvec3 d, double spread) const {
    const double up = std::clamp(d.y, -1.0, 1.0);
    const glm::dvec2 place(0.5 + std::atan2(d.x, -d.z) / (2 * pi), std::acos(up) / pi);
    const Pyramid& picture = cookie_->front();
    const double texels = static_cast<double>(picture.levels[0].height) / pi;
    const double narrow = std::max(std::sqrt(1 - up * up), 0.25); // meridians draw together towards the poles
    return between_levels(picture.levels.size(), spread * texels / narrow, [&](size_t k) {
        const Pyramid::Level& level = picture.levels[k];
        return mixed(level, place, [&](int64_t u, int64_t v) {
            return level.at((u + level.width) % level.width, std::clamp<int64_t>(v, 0, level.height - 1));
        });
    });
}

glm::dvec3 LightDistribution::cube(glm::dvec3 d, double spread) const {
    const size_t face = face_of(d);
    const Pyramid& picture = (*cookie_)[face];
    const glm::dvec2 place = place_on(faces[face], d);
    const double away = glm::dot(d, faces[face].axis);
    const double texels = spread * 0.5 * static_cast<double>(picture.levels[0].width) / (away * away);
    return between_levels(picture.levels.size(), texels, [&](size_t k) {
        return mixed(picture.levels[k], place,
                     [&](int64_t u, int64_t v) { return cube_texel(*cookie_, face, k, u, v); });
    });
}

double LightDistribution::profile(glm::dvec3 d) const {
    const LightProfile& p = *profile_;
    const double off_axis = std::acos(std::clamp(-d.z, -1.0, 1.0)) * 180 / pi;
    double around = std::atan2(d.y, d.x) * 180 / pi;
    around += around < 0 ? 360 : 0;
    if (off_axis < p.vertical.front() || off_axis > p.vertical.back())
        return 0;
    const size_t rows = p.vertical.size(), columns = p.horizontal.size();
    const auto above = std::upper_bound(p.vertical.begin(), p.vertical.end(), off_axis);
    const size_t row = std::min(static_cast<size_t>(above - p.vertical.begin()), rows - 1) - 1;
    const double t = (off_axis - p.vertical[row]) / (p.vertical[row + 1] - p.vertical[row]);
    const auto along = [&](size_t column) {
        return (1 - t) * p.candela[column * rows + row] + t * p.candela[column * rows + row + 1];
    };
    const auto beyond = std::upper_bound(p.horizontal.begin(), p.horizontal.end(), around);
    // The first angle is 0 unless only 90 … 270 was measured: then the last one lies before it, a turn back.
    const size_t after = static_cast<size_t>(beyond - p.horizontal.begin()) % columns,
                 before = (after + columns - 1) % columns;
    const double low = p.horizontal[before] - (after == 0 && around < p.horizontal[before] ? 360 : 0);
    const double gap = p.horizontal[after] - p.horizontal[before] + (after <= before ? 360 : 0);
    const double s = std::clamp((around - low) / gap, 0.0, 1.0);
    return ((1 - s) * along(before) + s * along(after)) / p.largest;
}

} // namespace prelight::reference
