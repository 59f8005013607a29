#pragma once
#include <glm/vec2.hpp>
#include <reference/ray_scene.hpp>
#include <span>

namespace prelight::reference {

/// A masked surface that let the ray pass.
struct Hole {
    double distance;
    uint32_t draw;
};

/// A blended surface that the ray went through.
struct Crossing {
    double distance;
    uint32_t draw, triangle;
    glm::dvec2 place{0}; ///< weights of the triangle's second and third corner
    bool along;          ///< the triangle's normal points with the ray
};

/// Finaliser of splitmix64 (Steele, Lea, Flood 2014): spreads a small number over 64 bits.
uint64_t scattered(uint64_t x);

/// Of what alpha tests let the ray pass before `limit`, the hit: Embree asks about triangles in any order, and a hole
/// beyond it tells nothing.
uint64_t hash_of(std::vector<Hole>& holes, double limit);

/// A ray through an edge or a corner meets all triangles around it, and a device one of them: leaves the first. What is
/// left is in the order of draws and triangles, whatever order Embree found it in.
void leave_one_each(std::vector<Crossing>& crossed, std::span<const Draw> draws);

/// Leaves layers up to a distance, and at it, and sorts them by distance; what lies at one distance by draw and
/// triangle.
void front_to_back(std::vector<Hit>& layers, double limit);

} // namespace prelight::reference
