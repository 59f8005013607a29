#pragma once
#include <prelight/scene.hpp>

namespace prelight {

// Maps of the scene `materials`, 256 texels a side, which repeat without a seam.

/// Height in 0 … 1 of bricks with mortar between them.
double brick_height(double u, double v);
/// Colour of the same bricks.
TextureImage brick_colours();
TextureImage brick_heights();
/// Normals of the bricks, and of a fine hammered pattern: tangent space, +Y up.
TextureImage brick_normals();
TextureImage hammered_normals();
/// Bands around the object: where detail is; where it is polished.
TextureImage bands();
TextureImage checks();
/// Glowing lines.
TextureImage circuits();

/// A sky, a ground, a bright window and a lamp; 128 × 64. Each value is one that RGBE holds.
Environment make_studio();

} // namespace prelight
