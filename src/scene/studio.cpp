// The built-in environment `studio`: a grey room with soft boxes, to judge materials in. Everything in it is grey, so
// that white stays white; a white wall that faces the usual camera sends on a little less than 1: base colours come out
// as they are.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// A rectangle that shines, far away. Angles as Framing has them: 0 is +Z, where the camera is, 90 is +X, to its right.
struct SoftBox {
    double azimuth, elevation; ///< of its middle, degrees
    double width, height;      ///< degrees
    double radiance;           ///< of its middle; the rim has three quarters of it
    double edge;               ///< degrees over which it ends
};

/// Key from the upper left, a weaker and larger fill from the right, a strip from either side behind that draws the
/// outline, one overhead, and a wide dim reflector behind the camera, so that rough metals that face it are not dull.
constexpr std::array<SoftBox, 6> boxes{{
    {-40, 34, 40, 30, 5.6, 4},
    {74, 14, 26, 52, 2.4, 8},
    {-122, 20, 14, 58, 4.5, 4},
    {142, 24, 18, 54, 5.0, 4},
    {20, 86, 40, 24, 3.0, 8},
    {15, 4, 96, 64, 0.32, 48},
}};

glm::dvec3 direction_to(double azimuth, double elevation) {
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation)};
}

double smooth(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double shine(const SoftBox& box, glm::dvec3 d) {
    const double azimuth = box.azimuth * degree;
    const glm::dvec3 middle = direction_to(azimuth, box.elevation * degree);
    const glm::dvec3 right(std::cos(azimuth), 0, -std::sin(azimuth)), up = glm::cross(middle, right);
    const double ahead = glm::dot(d, middle);
    if (ahead <= 0)
        return 0;
    const double across = std::abs(std::atan2(glm::dot(d, right), ahead)) / degree / (box.width / 2);
    const double along = std::abs(std::atan2(glm::dot(d, up), ahead)) / degree / (box.height / 2);
    const double inside = (1 - smooth(1 - box.edge / box.width, 1 + box.edge / box.width, across)) *
                          (1 - smooth(1 - box.edge / box.height, 1 + box.edge / box.height, along));
    return box.radiance * inside * (1 - 0.25 * std::min(0.5 * (across * across + along * along), 1.0));
}

/// The room without its lights: a floor that is brighter further out, walls that darken upwards to a grey ceiling.
double room(double elevation) {
    return elevation < 0 ? glm::mix(0.42, 0.12, smooth(0, 70, -elevation))
                         : glm::mix(0.42, 0.18, smooth(0, 65, elevation));
}

template <class Radiance>
Image paint(uint32_t width, const Radiance& radiance) {
    Image image(width, width / 2);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            const double azimuth = -(x + 0.5) / width * 2 * std::numbers::pi; // the middle is −Z, and +X to its right
            const double elevation = (0.5 - (y + 0.5) / image.height) * std::numbers::pi;
            image.at(x, y) = glm::vec3(float(radiance(azimuth, elevation)));
        }
    return image;
}

Image paint_studio() {
    return paint(512, [](double azimuth, double elevation) {
        double sum = room(elevation / degree);
        for (const SoftBox& box : boxes)
            sum += shine(box, direction_to(azimuth, elevation));
        return sum;
    });
}

} // namespace

Image soft_backdrop() {
    return paint(256, [](double, double elevation) {
        const double e = elevation / degree;
        return e < 0 ? glm::mix(0.50, 0.20, smooth(0, 55, -e)) : glm::mix(0.50, 0.24, smooth(0, 50, e));
    });
}

std::vector<BuiltinEnvironment> builtin_environments() {
    return {{"studio", "a grey room with soft boxes, for looking at one thing"}};
}

Environment make_environment(std::string_view name) {
    if (name != "studio")
        throw UsageError(fmt::format("{}: not a built-in environment (studio)", name));
    return {.name = "studio", .image = paint_studio(), .backdrop = soft_backdrop()};
}

} // namespace prelight
