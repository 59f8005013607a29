#pragma once
#include <cstddef>
#include <prelight/scene.hpp>

namespace prelight {

/// Expects generate_tangents(mesh, 0) to give each corner the tangent of the npm package
/// mikktspace, and prints the largest distance. `undefined`: how many of the oracle's may be no
/// unit vector.
void expect_oracle_tangents(const Primitive& mesh, size_t undefined = 0);

} // namespace prelight
