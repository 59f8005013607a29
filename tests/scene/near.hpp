#pragma once
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

namespace prelight::test {

/// Within `tolerance` in each coordinate.
inline void expect_near(glm::dvec3 a, glm::dvec3 b, double tolerance = 1e-6) {
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

} // namespace prelight::test
