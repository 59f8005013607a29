#pragma once
#include <optional>
#include <prelight/scene.hpp>
#include <scene/write/document.hpp>
#include <vector>

// The parts of a scene as glTF. What glTF has no field for stands in `extras.prelight`, so that the
// reader gives the same scene back; other programs skip it. The schema, all members optional:
//
//   root.extras.prelight.ambient      [r, g, b]  uniform environment radiance, linear; absent: 0 0
//   light.extras.prelight.falloff     "linear" | "quadratic"; absent: KHR_lights_punctual's own
//   root.extras.prelight.environment  {source: image, intensity: number ≥ 0, rotation: radians, background: bool,
//   backdrop: image}
//                                     equirectangular, RGBA is RGBE; Environment's fields; absent: ambient
//   light.extras.prelight.shininess   number > 0, [phong] light shininess; absent: 1
//   light.extras.prelight.castsShadow bool; absent: true
//   light.extras.prelight.size        number > 0, radius in metres; absent: 0.03
//   light.extras.prelight.cookie      {texture: textureInfo}  what it throws; of the textureInfo only `index` counts,
//   and of
//                                     that texture the image, whose colours are sRGB
//   light.extras.prelight.ies         URI of an IES file (LM-63), or {uri: …} or {bufferView: …}, with candela: true
//   where
//                                     `intensity` is a factor on the file's candela; else it is that of their maximum
//
//   material.extras.prelight.material    name of a built-in material (`prelight materials`); absent: the renderer's
//                                        own, or a file that is named elsewhere
//   material.extras.prelight.parameters  {NAME: number or [numbers]}, as that material declares them
//   material.extras.prelight.textures    {NAME: textureInfo}, likewise
//   material.extras.prelight.receivesDecals  bool; absent: true
//   material.extras.prelight.softness  metres ≥ 0; absent: 0
//
//   node.extras.prelight.receivesDecals  bool; absent: true
//   node.extras.prelight.decal    {material, opacity, order, fade: [from, to],
//                                  channels: ["colour", "normal", "roughness"]}
//   node.extras.prelight.emitter  {count, seed, lifetime: [from, to], speed: [from, to], cone, radius, gravity, drag,
//                                  ground, bounce, slip, colours: [[r, g, b], …], intensity, range, castsShadow,
//                                  lights, shape, size, sizes: […], opacities: […], streak, spin, material}
//                                 members as in prelight/decal.hpp and prelight/emitter.hpp, all but the materials
//                                 optional
//
// (`light` is an element of root.extensions.KHR_lights_punctual.lights.)
namespace prelight::write {

/// Images become PNG in the binary chunk; RGB where no pixel is transparent.
void add_images(const Scene& scene, Document& document);

/// Materials with their textures and samplers; each combination of image and sampler, and each
/// sampler, is written once. Factors are clamped to what glTF allows; emissive light above 1 goes
/// to KHR_materials_emissive_strength, as a power of two so that nothing is rounded.
void add_materials(const Scene& scene, Document& document);

/// Meshes with at least one triangle. Returns each mesh's index in the file; absent: not written.
/// A primitive without the texture coordinates that its material reads gets zeros.
std::vector<std::optional<uint32_t>> add_meshes(const Scene& scene, Document& document);

void add_lights(const Scene& scene, Document& document);
void add_cameras(const Scene& scene, Document& document);

/// Nodes and scenes. Throws Error for a transform that is not finite or has shear.
void add_nodes(const Scene& scene, const std::vector<std::optional<uint32_t>>& meshes, Document& document);

/// Skins and animations, after the nodes. Only meshes that are written have weights to animate.
void add_skins(const Scene& scene, Document& document);
void add_animations(const Scene& scene, const std::vector<std::optional<uint32_t>>& meshes, Document& document);

} // namespace prelight::write
