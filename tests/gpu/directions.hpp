#pragma once
#include <cmath>
#include <glm/glm.hpp>

namespace prelight {

/// Direction `i` of `count`, evenly spread over the sphere: each owns the same area of it (a spiral
/// with the golden angle), so that a plain mean over them is the mean over the sphere.
inline glm::dvec3 direction(uint32_t i, uint32_t count) {
    const double z = 1 - (2.0 * i + 1) / count;
    const double turn = 2.3999632297286533 * i;
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

/// Degrees between two directions of any length; exact for small angles too.
inline double angle(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 57.29577951308232;
}

/// Mean and maximum of many angles, degrees.
struct Angles {
    double sum = 0, max = 0;
    uint64_t count = 0;
    void add(double value) {
        sum += value;
        max = std::max(max, value);
        ++count;
    }
    double mean() const { return sum / static_cast<double>(count); }
};

} // namespace prelight
