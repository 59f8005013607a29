#pragma once
#include <scene/procedural/city_mesh.hpp>
#include <string_view>

namespace prelight::city {

/// Letters of bent tubes in the builder's frame, facing +d; the lower left corner of the first
/// letter is at `corner`, letters are `height` tall and half as wide. Capital letters, digits 2
/// and 4.
void neon_row(MeshBuilder& b, std::string_view text, glm::vec3 corner, float height, float radius);
/// One letter; see neon_row.
void neon_letter(MeshBuilder& b, char letter, glm::vec3 corner, float height, float radius);
/// Width of a row of letters.
float neon_width(std::string_view text, float height);

} // namespace prelight::city
