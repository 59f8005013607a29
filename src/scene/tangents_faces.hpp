#pragma once
#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace prelight::tangents {

inline constexpr uint32_t none = 0xffffffffu;

/// Vertices as MikkTSpace sees them; the spans are equally long.
struct Vertices {
    std::span<const glm::vec3> positions;
    std::span<const glm::vec3> normals;
    std::span<const glm::vec2> texcoords;
};

/// One triangle with area. Edge i runs from corner i to corner i + 1.
struct Face {
    std::array<uint32_t, 3> corners{}; ///< index of a representative vertex: equal where all is equal
    std::array<uint32_t, 3> neighbours{none, none, none}; ///< face across edge i
    glm::vec3 s{0};          ///< unit: the direction in which u grows, in the triangle's plane
    glm::vec3 t{0};          ///< unit: the direction in which v grows
    bool preserving = false; ///< texture coordinates are counter-clockwise like the triangle
    bool with_any = true;    ///< texture coordinates span no area: joins whichever group comes first
    uint32_t triangle = 0;   ///< its place in the index list ÷ 3
};

/// For each vertex the first one (in order of value) with the same position, normal and texture
/// coordinate. −0 equals 0.
std::vector<uint32_t> weld(const Vertices& vertices);

/// The triangles whose three positions differ, with frames and neighbours, in the list's order.
/// Two faces are neighbours across an edge that both have, in opposite directions; where more than
/// two share an edge they pair up in order.
std::vector<Face> make_faces(const Vertices& vertices, std::span<const uint32_t> indices,
                             std::span<const uint32_t> welded);

/// |x| above the smallest normal float: MikkTSpace's threshold for "not zero".
bool not_zero(float x);
/// v divided by its length, or v itself where every component counts as zero.
glm::vec3 unit_or_zero(const glm::vec3& v);

} // namespace prelight::tangents
