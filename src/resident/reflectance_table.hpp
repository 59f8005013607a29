#pragma once
#include <prelight/image.hpp>

namespace prelight::resident {

/// What a rough mirror sends on of light that is the same from everywhere, for N·V 0 … 1 along x and roughness 0 … 1
/// along y, both ends included: ∫ D V N·L dω with glTF 2.0's D and V, in R what F0 scales of it and in G what F90 does
/// (Schlick's Fresnel term; Karis, "Real Shading in Unreal Engine 4", 2013).
Image make_reflectance_table();

} // namespace prelight::resident
