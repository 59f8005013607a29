#pragma once
#include <cmath>
#include <glm/mat4x4.hpp>

namespace prelight {

inline bool is_finite(const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(m[column][row]))
                return false;
    return true;
}

} // namespace prelight
