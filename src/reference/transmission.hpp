#pragma once
#include <reference/behind.hpp>
#include <reference/lens.hpp>
#include <reference/surface.hpp>

namespace prelight::reference {

/// Where the picture behind a transmissive surface is looked at (docs/transmission.md).
struct LookBehind {
    glm::dvec2 place{0}; ///< pixels from the picture's top left
    double level;        ///< of Behind
};

/// `pixel`: the place of the picture where the surface itself is seen. Light is refracted once, where it comes in, and
/// leaves the body after its thickness.
LookBehind look_behind(const Surface& surface, const Lens& lens, glm::dvec2 pixel);

/// The share of light that comes through the body's thickness: Beer's law.
glm::dvec3 transmittance(const Surface& surface);

/// Roughness (perceptual) as light meets it that comes through: none where the body does not bend it.
double roughness_through(const Surface& surface, double roughness);

} // namespace prelight::reference
