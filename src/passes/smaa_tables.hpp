#pragma once
#include <cstdint>
#include <shared/smaa.h>
#include <vector>

namespace prelight::passes {

/// How much two pixels that an edge parts take of each other: shares of their area, 0 … 1.
struct EdgeAreas {
    double below = 0; ///< of the pixel below the edge that lies above the revectorised line
    double above = 0; ///< of the pixel above the edge that lies below it
};

/// An edge along a row, `left` pixels from the line's left end and `right` from its right one; `before` and `after` say
/// what crosses there (SMAA_CROSSING_ABOVE | _BELOW). Jimenez and others, "SMAA: Enhanced Subpixel Morphological
/// Antialiasing", 2012; the patterns are those of Jimenez's MLAA ("Practical Morphological Anti-Aliasing",
/// GPU Pro 2, 2011): L, Z and U.
EdgeAreas smaa_area(int before, int after, int left, int right);

/// An edge along a row that is a step of a staircase from below left to above right, with `left` and `right` more such
/// steps (SMAA, "Diagonal patterns"). Crossings: SMAA_CROSSING_UPRIGHT | _LEVEL. The other diagonal is this one upside
/// down.
EdgeAreas smaa_diagonal_area(int before, int after, int left, int right);

/// All of both where smaa_area_index() and smaa_diagonal_index() find them: `below` in the low half, 0 … 65,535.
std::vector<uint32_t> smaa_areas();

} // namespace prelight::passes
