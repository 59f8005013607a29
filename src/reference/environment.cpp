#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <numbers>
#include <reference/environment.hpp>

namespace prelight::reference {
namespace {

using std::numbers::pi;
constexpr int directions = 384; ///< of a lobe

} // namespace

EnvironmentLight::EnvironmentLight(const Environment* environment) : environment_(environment) {
    if (!environment)
        return;
    levels_.push_back(level_of(environment->image));
    backdrop_ = level_of(environment->backdrop);
    while (levels_.back().width % 2 == 0 && levels_.back().height % 2 == 0) {
        const Level& fine = levels_.back();
        Level coarse{fine.width / 2, fine.height / 2, {}};
        for (size_t y = 0; y < coarse.height; ++y)
            for (size_t x = 0; x < coarse.width; ++x) {
                const size_t corner = 2 * y * fine.width + 2 * x;
                coarse.texels.push_back((fine.texels[corner] + fine.texels[corner + 1] +
                                         fine.texels[corner + fine.width] + fine.texels[corner + fine.width + 1]) /
                                        4.0);
            }
        levels_.push_back(std::move(coarse));
    }
    take_moments();
}

EnvironmentLight::Level EnvironmentLight::level_of(const Image& image) const {
    Level level{image.width, image.height, {}};
    for (const glm::vec3& texel : image.pixels)
        level.texels.push_back(glm::dvec3(texel) * double(environment_->intensity));
    return level;
}

void EnvironmentLight::take_moments() {
    const Level& map = levels_.front();
    for (uint32_t y = 0; y < map.height; ++y) {
        const double latitude = pi * (0.5 - (y + 0.5) / map.height);
        // Of a texel: Δlongitude · Δ sin(latitude).
        const double area =
            2 * pi / map.width *
            (std::sin(pi * (0.5 - double(y) / map.height)) - std::sin(pi * (0.5 - (y + 1.0) / map.height)));
        for (uint32_t x = 0; x < map.width; ++x) {
            const double longitude = 2 * pi * ((x + 0.5) / map.width - 0.5) - environment_->rotation;
            const glm::dvec3 d(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                               -std::cos(latitude) * std::cos(longitude));
            const glm::dvec3 light = area * map.texels[size_t(y) * map.width + x];
            zeroth_ += light;
            for (int c = 0; c < 3; ++c) {
                first_[size_t(c)] += light[c] * d;
                second_[size_t(c)] += light[c] * glm::outerProduct(d, d);
            }
        }
    }
}

glm::dvec3 EnvironmentLight::Level::bilinear(double longitude, double latitude) const {
    const double column = (longitude / (2 * pi) + 0.5) * width - 0.5;
    const double row = std::clamp((0.5 - latitude / pi) * height - 0.5, 0.0, double(height - 1));
    const double left = std::floor(column), top = std::floor(row);
    const auto texel = [&](double x, double y) {
        const auto wide = int64_t(width);
        const int64_t wrapped = ((int64_t(x) % wide) + wide) % wide;
        const int64_t clamped = std::min<int64_t>(int64_t(y), int64_t(height) - 1);
        return texels[size_t(clamped) * width + size_t(wrapped)];
    };
    const double s = column - left, t = row - top;
    return (1 - t) * ((1 - s) * texel(left, top) + s * texel(left + 1, top)) +
           t * ((1 - s) * texel(left, top + 1) + s * texel(left + 1, top + 1));
}

glm::dvec3 EnvironmentLight::look(const Level& level, glm::dvec3 direction) const {
    return level.bilinear(std::atan2(direction.x, -direction.z) + environment_->rotation,
                          std::asin(std::clamp(direction.y, -1.0, 1.0)));
}

glm::dvec3 EnvironmentLight::background(glm::dvec3 direction) const {
    return look(backdrop_.texels.empty() ? levels_.front() : backdrop_, direction);
}

glm::dvec3 EnvironmentLight::blurred(glm::dvec3 direction, double level) const {
    const double place = std::clamp(level, 0.0, double(levels_.size() - 1));
    const auto fine = size_t(place);
    const double share = place - double(fine);
    const glm::dvec3 value = look(levels_[fine], direction);
    return share > 0 ? value + share * (look(levels_[fine + 1], direction) - value) : value;
}

// Lambert's cosine lobe over π has a sum (1 / 4π) Σ (2l + 1) a_l P_l(cos θ) with a = 1, 2/3, 1/4 (Ramamoorthi and
// Hanrahan 2001); P_1 and P_2 of n·d are the first and second moments of the light, written out.
glm::dvec3 EnvironmentLight::lambert(glm::dvec3 n) const {
    glm::dvec3 out{0};
    for (int c = 0; c < 3; ++c) {
        const double flat = zeroth_[c], slope = glm::dot(first_[size_t(c)], n),
                     bend = glm::dot(n, second_[size_t(c)] * n);
        out[c] = std::max((flat + 2 * slope + 1.25 * (1.5 * bend - 0.5 * flat)) / (4 * pi), 0.0);
    }
    return out;
}

glm::dvec3 EnvironmentLight::mirrored(glm::dvec3 direction, double roughness) const {
    const double r = std::clamp(roughness, 0.0, 1.0);
    const double step = r < 0.125 ? 8 * r : 1 + 4 * std::log2(8 * r), below = std::floor(step), share = step - below;
    const auto of_step = [&](double i) { return lobe(direction, i < 1 ? 0 : std::exp2((i - 1) / 4) / 8); };
    return share < 1e-9 ? of_step(below) : (1 - share) * of_step(below) + share * of_step(below + 1);
}

glm::dvec3 EnvironmentLight::lobe(glm::dvec3 direction, double roughness) const {
    const double a = std::min(roughness * roughness, 1.0);
    if (a < 1e-6)
        return radiance(direction);
    const glm::dvec3 helper = std::abs(direction.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 u = glm::normalize(glm::cross(helper, direction)), v = glm::cross(direction, u);
    const double texel = 2 * pi / levels_.front().width;
    glm::dvec3 sum(0);
    double weight = 0;
    for (int i = 0; i < directions; ++i) { // of a Fibonacci lattice
        // Equal shares of ∫ D N·H dω: tan² θ = a² e / (1 − e).
        const double e = (i + 0.5) / directions, theta = std::atan(a * std::sqrt(e / (1 - e)));
        const double nl = std::cos(2 * theta), phi = 2 * pi * std::fmod(i * std::numbers::phi, 1.0);
        if (nl <= 0)
            continue;
        // Each light stands for 4 / (directions · D) of all; the map is averaged over about that.
        const double c2 = std::pow(std::cos(theta), 2), spread = c2 * (a * a - 1) + 1;
        const double solid_angle = 4 * pi * spread * spread / (a * a * directions);
        const double level = 0.5 * std::log2(solid_angle / (texel * texel));
        const glm::dvec3 light = direction * nl + std::sin(2 * theta) * (std::cos(phi) * u + std::sin(phi) * v);
        sum += nl * blurred(light, level);
        weight += nl;
    }
    return sum / weight;
}

namespace {

/// ∫ D V N·L and ∫ D V N·L (1 − V·H)⁵ over light directions, by rings of half vectors around the normal.
glm::dvec2 uniform_integrals(double roughness, double nv) {
    const double a = std::max(roughness * roughness, 1e-4), a2 = a * a, sv = std::sqrt(1 - nv * nv);
    constexpr int circles = 96, points = 48;
    glm::dvec2 sum(0);
    for (int i = 0; i < circles; ++i) {
        // tan² θ = a² u / (1 − u) turns D N·H dω into du dφ / 2π.
        const double u = (i + 0.5) / circles, theta = std::atan(a * std::sqrt(u / (1 - u)));
        for (int j = 0; j < points; ++j) {
            const double phi = pi * (j + 0.5) / points; // the other half is alike
            const double vh = sv * std::sin(theta) * std::cos(phi) + nv * std::cos(theta);
            const double nl = 2 * vh * std::cos(theta) - nv;
            if (nl <= 0 || vh <= 0)
                continue;
            const auto smith = [&](double c) { return c + std::sqrt(a2 + (1 - a2) * c * c); };
            const double value = 4 * nl * vh / (std::cos(theta) * smith(nl) * smith(nv));
            sum += value * glm::dvec2(1, std::pow(1 - vh, 5));
        }
    }
    return sum / double(circles * points);
}

constexpr int table_size = 65;

std::vector<glm::dvec2> make_table() {
    std::vector<glm::dvec2> table;
    for (int y = 0; y < table_size; ++y)
        for (int x = 0; x < table_size; ++x)
            table.push_back(uniform_integrals(y / (table_size - 1.0), std::max(x / (table_size - 1.0), 1e-3)));
    return table;
}

} // namespace

glm::dvec3 mirror_direction(glm::dvec3 normal, glm::dvec3 view, double roughness) {
    const glm::dvec3 reflection = 2 * glm::dot(normal, view) * normal - view;
    return glm::normalize(reflection + (normal - reflection) * std::min(std::pow(roughness, 4), 1.0));
}

glm::dvec3 environment_share(glm::dvec3 f0, double f90, double roughness, double nv) {
    static const std::vector<glm::dvec2> table = make_table();
    const double x = std::clamp(nv, 0.0, 1.0) * (table_size - 1),
                 y = std::clamp(roughness, 0.0, 1.0) * (table_size - 1);
    const int left = std::min(int(x), table_size - 2), top = std::min(int(y), table_size - 2);
    const glm::dvec2* corner = &table[size_t(top) * table_size + size_t(left)];
    const glm::dvec2 integrals = glm::mix(glm::mix(corner[0], corner[1], x - left),
                                          glm::mix(corner[table_size], corner[table_size + 1], x - left), y - top);
    return f0 * (integrals.x - integrals.y) + f90 * integrals.y;
}

glm::dvec3 uniform_share(glm::dvec3 f0, double roughness, double nv) {
    const double x = 1 - roughness, y = 0.0425 - 0.0275 * roughness;
    const double a = std::min(x * x, std::exp2(-9.28 * nv)) * x + y;
    return f0 * (-1.04 * a + 1.04 - 0.572 * roughness) + (1.04 * a + 0.022 * roughness - 0.04);
}

double mirror_visibility(double nv, double visibility, double roughness) {
    const double bent = std::pow(std::max(nv + visibility, 1e-6), std::exp2(-1 - 16 * roughness));
    return std::clamp(bent + visibility - 1, 0.0, 1.0);
}

} // namespace prelight::reference
