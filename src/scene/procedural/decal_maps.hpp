#pragma once
#include <prelight/scene.hpp>

namespace prelight {

// Pictures of the scene `decals`, 256 texels a side; what is transparent leaves the surface as it is.

/// A net of cracks that thins out towards the edges: dark lines, and their slopes.
TextureImage crack_colours();
TextureImage crack_normals();
/// A painted arrow with worn edges, which points up.
TextureImage arrow();
/// A ring around a cross.
TextureImage target();
/// 4 × 2 round heads of bolts: colours, normals, and metallic-roughness.
TextureImage bolt_colours();
TextureImage bolt_normals();
/// White, with the outline of a puddle as coverage.
TextureImage puddle();
/// A black burn, soft at its edge.
TextureImage scorch();

} // namespace prelight
