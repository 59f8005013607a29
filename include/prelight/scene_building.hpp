#pragma once
#include <prelight/scene.hpp>

namespace prelight {

/// Scenes that a program fills itself, without a file. Scene is a plain struct, and these check and complete what goes
/// into it, as the reader does for files. All throw Error "SCENE: OBJECT: REASON"; the scene is as before then.

/// Adds a picture for materials (TextureRef::image): rgba has width × height × 4 bytes. Gives its index.
PRELIGHT_API uint32_t add_image(Scene& scene, TextureImage image);
/// Adds a material, whose images are there. Gives its index.
PRELIGHT_API uint32_t add_material(Scene& scene, Material material);
/// Adds triangles with one of the scene's materials, shown once, at `transform` (object → world, as Node::local): a
/// mesh with a node in the default tree, which is made with the first one. Positions are needed. Without indices they
/// are 0, 1, 2 …; without normals each triangle gets its own, and each of its corners a vertex; without tangents they
/// are made where the material has a normal map; what faces the viewer (Primitive::facing) gets (0, 0, 1) and (1, 0,
/// 0). Gives the index of the node, which is also `World::instances[i].node`.
PRELIGHT_API uint32_t add_object(Scene& scene, std::string name, Primitive primitive, uint32_t material,
                                 const glm::dmat4& transform = glm::dmat4(1));

} // namespace prelight
