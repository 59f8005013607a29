#pragma once
#include <glm/geometric.hpp>
#include <numbers>
#include <prelight/scene.hpp>
#include <span>
#include <string>
#include <vector>

namespace prelight::city {

inline constexpr float pi = std::numbers::pi_v<float>;

/// Index into Scene::materials; city_materials.cpp makes them in this order.
enum class Surface : uint32_t {
    asphalt,
    marking,
    paving,
    kerb,
    brick,
    plaster,
    trim,
    frame,
    window,
    shop,
    wood,
    metal,
    glow,
    board,
    car_paint,
    car_glass,
    rubber,
    chrome,
    bark,
    leaves,
    roofing,
    fabric,
    grating,
    sky,
    count
};

/// Colours of the one emissive material: cells of its palette.
enum class Glow : uint32_t {
    warm_white,
    cool_white,
    amber,
    red,
    pink,
    magenta,
    violet,
    blue,
    cyan,
    green,
    yellow,
    orange,
    count
};

/// A right-handed local frame: `s` to the right, `y` up, `d` towards the viewer.
struct Frame {
    glm::vec3 origin{0};
    glm::vec3 s{1, 0, 0}, y{0, 1, 0}, d{0, 0, 1};

    glm::vec3 point(glm::vec3 p) const { return origin + vector(p); }
    glm::vec3 vector(glm::vec3 v) const { return v.x * s + v.y * y + v.z * d; }
    /// The frame at the local point `p`, same axes.
    Frame at(glm::vec3 p) const { return {point(p), s, y, d}; }
    /// Turned about `y` by quarter turns: `s` becomes −d.
    Frame turned() const { return {origin, -d, y, s}; }
};

/// Faces of a box, to be left out where nothing can see them.
enum Faces : unsigned { left = 1, right = 2, bottom = 4, top = 8, back = 16, front = 32, all_faces = 63 };

/// A texture rectangle: u0, v0 at the lower left corner of a quad, u1, v1 at its upper right one.
struct TexRect {
    glm::vec2 lower_left{0, 1}, upper_right{1, 0};
};

/// Gathers one mesh, a primitive for each material. Everything is given in the current frame.
/// Surfaces get unit normals, texture coordinates in metres ÷ the material's tile (or a rectangle
/// of the texture) where the material is textured, and exact tangents where it has a normal map.
class MeshBuilder {
public:
    Frame frame;
    Surface surface = Surface::trim;
    glm::vec3 tint{1}; ///< vertex colour, linear

    MeshBuilder& use(Surface new_surface, glm::vec3 new_tint = glm::vec3(1));
    /// The emissive material in one of its colours.
    MeshBuilder& use(Glow colour);

    /// Parallelogram o, o + u, o + u + v, o + v, facing u × v.
    void quad(glm::vec3 o, glm::vec3 u, glm::vec3 v);
    void quad(glm::vec3 o, glm::vec3 u, glm::vec3 v, const TexRect& rect);
    /// Axis-aligned box.
    void box(glm::vec3 low, glm::vec3 high, unsigned faces = all_faces);
    /// Sides of a truncated cone from `from` to `to`, and both ends when `caps`.
    void cone(glm::vec3 from, glm::vec3 to, float radius_from, float radius_to, uint32_t sides, bool caps = true);
    /// Polyline of round tubes with closed ends.
    void tube(std::span<const glm::vec3> points, float radius, uint32_t sides);
    void sphere(glm::vec3 centre, glm::vec3 radii, uint32_t slices, uint32_t stacks);
    /// Octahedron with flat faces, for bulbs.
    void gem(glm::vec3 centre, float radius);
    /// Rows × columns of points with smooth normals: row-major, `columns` to a row, facing
    /// (along a row) × (along a column). Points that coincide at an edge are given twice.
    void patch(std::span<const glm::vec3> points, uint32_t columns);
    /// Flat convex polygon, counter-clockwise from outside.
    void polygon(std::span<const glm::vec3> points);

    /// The mesh; its vertices are relative to the world point `origin`. Leaves the builder empty.
    Mesh finish(std::string name, glm::vec3 origin = glm::vec3(0));

private:
    Primitive& primitive();
    uint32_t vertex(Primitive& p, glm::vec3 local, glm::vec3 normal, glm::vec3 u_axis, glm::vec2 uv);
    glm::vec2 planar(glm::vec3 local, glm::vec3 u_axis, glm::vec3 v_axis) const;

    std::vector<Primitive> primitives; ///< by Surface, empty ones included
    glm::vec2 palette{0};              ///< where the emissive palette is read
};

/// Metres covered by one repeat of the material's textures; 0: not textured.
float tile_metres(Surface surface);
bool has_normal_map(Surface surface);

} // namespace prelight::city
