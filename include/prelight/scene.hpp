#pragma once
#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <prelight/animation.hpp>
#include <prelight/camera.hpp>
#include <prelight/decal.hpp>
#include <prelight/emitter.hpp>
#include <prelight/export.hpp>
#include <prelight/glm_defaults.hpp>
#include <prelight/image.hpp>
#include <prelight/light.hpp>
#include <prelight/material.hpp>
#include <string>
#include <vector>

namespace prelight {

/// 8-bit RGBA picture as decoded from the file, row by row from the top.
struct TextureImage {
    std::string name;          ///< for messages
    uint32_t width = 0;        ///< pixels
    uint32_t height = 0;       ///< pixels
    std::vector<uint8_t> rgba; ///< width × height × 4
};

/// Light from all around, infinitely far away.
struct Environment {
    std::string name; ///< for messages
    /// Equirectangular, twice as wide as high; radiance, linear Rec. 709. The middle is seen along −Z, the
    /// top row lies towards +Y, left of the middle towards −X.
    Image image{};
    float intensity = 1;    ///< factor on the image's radiance, ≥ 0 and finite
    double rotation = 0;    ///< radians about +Y, counter-clockwise seen from above: π/2 puts the middle along −X
    bool background = true; ///< seen where nothing is drawn
    /// What is seen there in place of `image`, as wide as high twice over too, with the same intensity and rotation. It
    /// lights nothing. Empty: `image`.
    Image backdrop{};
};

/// Four of the joints that move each vertex. A vertex's place is the sum over all sets of weight ×
/// joint matrix × position; its weights sum up to 1.
struct JointSet {
    std::vector<glm::vec<4, uint16_t>> joints; ///< indices into Skin::joints
    std::vector<glm::vec4> weights;            ///< ≥ 0
};

/// What a morph target adds to each vertex at weight 1. Each list is empty (nothing) or as long as
/// the primitive's positions.
struct MorphTarget {
    std::vector<glm::vec3> positions{}; ///< metres, object space
    std::vector<glm::vec3> normals{};   ///< before they are made unit length again
    std::vector<glm::vec3> tangents{};  ///< likewise; to their xyz
};

/// One draw: triangles with one material. Attributes are either empty or as long as `positions`.
/// After loading every primitive has normals and tangents (flat / MikkTSpace where the file had none;
/// tangents stay empty when the material has no normal map).
struct Primitive {
    std::vector<glm::vec3> positions;                ///< object space, metres
    std::vector<glm::vec3> normals;                  ///< unit length
    std::vector<glm::vec4> tangents;                 ///< xyz unit, w = ±1: bitangent = w·(N × T)
    std::array<std::vector<glm::vec2>, 2> texcoords; ///< (0, 0) is the image's top left
    std::vector<glm::vec4> colours;                  ///< linear RGBA 0 … 1; empty: white
    std::vector<uint32_t> indices;                   ///< triangle list, counter-clockwise front
    uint32_t material = 0;                           ///< index into Scene::materials
    std::vector<JointSet> joint_sets{};              ///< for nodes with a skin
    std::vector<MorphTarget> morph_targets{};        ///< each primitive of a mesh has as many
    bool flat_normals = false;                       ///< the triangles' own: made anew when the primitive is deformed
    /// Only in World::deformed: where each vertex was at the moment's previous state, in the space of
    /// `positions`. Empty: there too.
    std::vector<glm::vec3> previous_positions{};
    /// Metres along the viewer's right and up: where each vertex stands from its position, seen by whichever camera.
    /// Normals and tangents are then in the viewer's axes (right, up, towards the viewer), and shadows are those of the
    /// triangles as that camera sees them. Neither an instance's turn nor its scale changes these offsets. Empty:
    /// positions are where vertices are.
    std::vector<glm::vec2> facing{};
};

/// What nodes show: triangles, a primitive for each material.
struct Mesh {
    std::string name;                  ///< of the file; may be empty
    std::vector<Primitive> primitives; ///< drawn one by one
    std::vector<float> weights{};      ///< of the morph targets; empty: all zero
};

/// A place in a scene's tree, and what is there. Double precision: a scene 10 km from the origin keeps its millimetres.
struct Node {
    std::string name;                  ///< of the file; may be empty
    glm::dmat4 local{1};               ///< to the parent's space; last row 0 0 0 1, finite
    std::vector<uint32_t> children;    ///< a forest: each node has at most one parent, no cycle
    std::optional<uint32_t> mesh;      ///< index into Scene::meshes
    std::optional<uint32_t> camera;    ///< index into Scene::cameras
    std::optional<uint32_t> light;     ///< index into Scene::lights
    std::vector<glm::dmat4> instances; ///< EXT_mesh_gpu_instancing; empty: one, identity
    /// What `local` is made of; absent when the file gives a matrix. Animation needs it.
    std::optional<Trs> trs{};
    std::optional<uint32_t> skin{};    ///< the mesh follows these joints and not this node
    std::vector<float> weights{};      ///< of the mesh's morph targets; empty: Mesh::weights
    std::optional<uint32_t> decal{};   ///< index into Scene::decals; the node is its box
    std::optional<uint32_t> emitter{}; ///< index into Scene::emitters
    bool receives_decals = true;       ///< decals lie on its mesh
    /// KHR_node_visibility: false hides mesh, light, decal and emitter of the node and of all below it.
    /// Joints still move and cameras still see.
    bool visible = true;
};

/// One of the file's scenes: a name and its root nodes.
struct SceneRoot {
    std::string name;            ///< of the file; may be empty
    std::vector<uint32_t> nodes; ///< indices into Scene::nodes
};

/// What a file holds, or a program fills itself (scene_building.hpp): resolve() makes a World of it. Parts name each
/// other by their index.
struct Scene {
    std::string name;                    ///< file or built-in name, for messages
    std::vector<TextureImage> images;    ///< for materials, and cookies of lights
    std::vector<Material> materials;     ///< of primitives, decals and emitters
    std::vector<Mesh> meshes;            ///< that nodes show
    std::vector<Light> lights;           ///< that nodes carry
    std::vector<Camera> cameras;         ///< that nodes carry
    std::vector<Node> nodes;             ///< of all trees
    std::vector<SceneRoot> scenes;       ///< at least one
    uint32_t default_scene = 0;          ///< the tree that is shown when nobody says which: index into `scenes`
    std::vector<Animation> animations{}; ///< that move nodes
    std::vector<Skin> skins{};           ///< that nodes' meshes follow
    std::vector<Decal> decals{};         ///< that nodes carry
    std::vector<Emitter> emitters{};     ///< that nodes carry
    glm::vec3 ambient{0};                ///< uniform environment radiance, linear RGB
    /// Light from all around, in place of `ambient`, which it makes unused; null: `ambient`.
    std::shared_ptr<const Environment> environment{};
    std::vector<std::string> warnings; ///< what the loader repaired or left out: "FILE: OBJECT: REASON", one line each
};

/// How morph targets and a skin shape one of World::deformed at the moment: from it a renderer on a device makes the
/// vertices itself.
struct Deformation {
    /// Index into Scene::meshes; absent: nothing but World::deformed says what the vertices are (particles).
    std::optional<uint32_t> mesh{};
    std::vector<glm::mat4> joints{}; ///< by Skin::joints: mesh → the space of the deformed vertices; empty: no skin
    std::vector<float> weights{};    ///< one for each morph target
    std::vector<glm::mat4> previous_joints{}; ///< at the moment's previous state, into the same space; as many
    std::vector<float> previous_weights{};    ///< likewise
    bool turned = false;                      ///< the joints mirror: fronts of the mesh's triangles are clockwise
    glm::vec3 low{0};                         ///< of a box around all vertices, in the space of the deformed ones
    glm::vec3 high{0};                        ///< likewise
    /// Member by member.
    bool operator==(const Deformation&) const = default;
};

/// One drawn object: a mesh at a place.
struct Instance {
    uint32_t mesh = 0;       ///< index into Scene::meshes
    glm::dmat4 transform{1}; ///< object → world
    bool mirrored = false;   ///< negative determinant: front faces are clockwise
    uint32_t node = 0;       ///< index into Scene::nodes, which it comes from
    /// Index into World::deformed: morph targets or a skin move its vertices. See World::mesh_of.
    std::optional<uint32_t> deformed{};
    /// `transform` at the moment's previous state; absent: the same.
    std::optional<glm::dmat4> previous_transform{};
    bool receives_decals = true; ///< as its node and, primitive by primitive, its material say
    bool visible = true;         ///< false: not drawn, and casts no shadow. resolve() leaves hidden nodes out
};

/// A light at its place in the world.
struct PlacedLight {
    Light light;                    ///< what shines there
    glm::dvec3 position{0};         ///< world, metres
    glm::dvec3 direction{0, 0, -1}; ///< world, unit: the way the light shines
    /// World: the node's +Y axis, which is up in its cookie. What of it lies along `direction` does not
    /// count (light_axes() in light_distribution.hpp).
    glm::dvec3 up{0, 1, 0};
};

/// What one frame shows: the node tree resolved to world space, in the order of a depth-first walk.
/// May be copied and moved.
struct World {
    const Scene* scene = nullptr;    ///< meshes, materials, images; must outlive the World
    std::vector<Instance> instances; ///< of the nodes, then of the emitters' particles
    std::vector<Mesh> deformed{};    ///< meshes as morph targets and skins shape them at the moment, and particles
    std::vector<Deformation> deformations{}; ///< beside `deformed`
    std::vector<PlacedLight> lights;         ///< of the nodes, then of the emitters' particles
    std::vector<PlacedDecal> decals{};       ///< by Decal::order: later ones lie over earlier ones
    std::vector<PlacedCamera> cameras;       ///< of the nodes; at least one
    bool framed = false;                     ///< cameras[0] is resolve()'s own frame(): the scene has none
    glm::vec3 ambient{0};     ///< uniform environment radiance; unused where the scene has an environment
    glm::dvec3 bounds_min{0}; ///< of all triangles' vertices, metres
    glm::dvec3 bounds_max{0}; ///< likewise
    uint64_t triangles = 0;   ///< of all instances

    /// What the instance shows: its deformed mesh, or else the scene's.
    const Mesh& mesh_of(const Instance& instance) const {
        return instance.deformed ? deformed.at(*instance.deformed) : scene->meshes.at(instance.mesh);
    }
};

/// What of a world is not as a renderer took it in last (Renderer::update_world): the numbers of the entries that were
/// changed where they stand. Entries keep their number; what else changed makes it `all`.
struct WorldChanges {
    bool all = false; ///< anything may have changed
    /// Of World::instances: transform, previous_transform, mirrored, visible.
    std::vector<uint32_t> instances{};
    /// Of World::deformed: positions, previous positions, normals, tangents, colours and texture coordinates.
    std::vector<uint32_t> deformed{};
    /// Of Scene::materials.
    std::vector<uint32_t> materials{};
    bool lights = false; ///< any of World::lights, or their number
    bool decals = false; ///< any of World::decals
    /// And these, which came later.
    PRELIGHT_API void add(const WorldChanges& more);
    /// Whether nothing has changed.
    bool empty() const {
        return !all && instances.empty() && deformed.empty() && materials.empty() && !lights && !decals;
    }
};

/// Whether anything shines in one of the scene's trees: a node with a light or an emitter, ambient light, an
/// environment.
PRELIGHT_API bool is_lit(const Scene& scene, std::optional<uint32_t> scene_index = {});
/// Whether a node of the tree has a camera: else resolve() makes one.
PRELIGHT_API bool has_camera(const Scene& scene, std::optional<uint32_t> scene_index = {});

/// Resolves one of the scene's trees (`scene_index`: default one when absent). A world without a
/// camera gets one named "framed" (frame() in framing.hpp, for a square picture) or, when the
/// world is a room or a courtyard, one named "inside" (see scene/enclosure.hpp). One that is not is_lit()
/// gets the documented key light (directional, 3 lux, from the upper left behind
/// the camera: direction (−0.4, −0.8, −0.45) normalised) and ambient 0.25. Whoever would rather have the studio gives
/// the scene make_environment("studio") (scene_io.hpp) before. Without a `moment` nodes and morph weights are as the
/// file gives them (skins are in the pose of their joints) and nothing has moved. With one they are as the animations
/// put them at its time, and the "previous" members of instances, vertices and cameras tell where things were one
/// interval earlier. `animation`: only this one of Scene::animations; absent: all, and where several change the same
/// property of a node, the first in the file's order. Particles of emitters are as they are at the moment's time,
/// without one at time 0. A tree without triangles is an empty picture; warnings_of() says what there was instead.
/// Throws Error: a world transform that is not finite, an animation or skin that does not fit its node.
PRELIGHT_API World resolve(const Scene& scene, std::optional<uint32_t> scene_index = {},
                           const std::optional<Moment>& moment = {}, std::optional<uint32_t> animation = {});

/// Scene::warnings, and what of the tree that the world was made of cannot be shown, one line each.
PRELIGHT_API std::vector<std::string> warnings_of(const World& world);

/// Index into Scene::animations, by name or by index in decimal. Throws UsageError listing what there
/// is.
PRELIGHT_API uint32_t find_animation(const Scene& scene, const std::string& name_or_index);
/// Index into Scene::scenes, likewise.
PRELIGHT_API uint32_t find_scene(const Scene& scene, const std::string& name_or_index);

/// Adds `count` point lights, uniform in the world's bounds, hues from `seed`, with the range that
/// puts about 8 of them on a point and intensity range²/2 cd.
PRELIGHT_API void scatter_lights(World& world, uint32_t count, uint64_t seed);

/// By name or by index in decimal. Throws UsageError listing what there is.
PRELIGHT_API const PlacedCamera& find_camera(const World& world, const std::string& name_or_index);

} // namespace prelight
