#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <prelight/error.hpp>
#include <prelight/framing.hpp>
#include <prelight/scene.hpp>
#include <scene/deformation.hpp>
#include <scene/emit.hpp>
#include <scene/enclosure.hpp>
#include <scene/finite.hpp>
#include <scene/mesh_facts.hpp>
#include <scene/node_tree.hpp>
#include <scene/place_camera.hpp>
#include <span>
#include <tuple>

namespace prelight {
namespace {

/// Vertex transforms that bounds may cost; beyond it a mesh's box stands for its vertices, so that
/// a file with a million instances of a million vertices cannot stall the program.
constexpr uint64_t max_exact_vertices = uint64_t(1) << 25;
/// Vertices that may be deformed, about 100 bytes each, and what that may cost (deform_work): a
/// file of many nodes that each shape one large mesh must not fill the machine either.
constexpr uint64_t max_deformed_vertices = uint64_t(1) << 23;
constexpr uint64_t max_deform_work = uint64_t(1) << 27;

/// Determinant of the linear part with each axis scaled to unit length: its sign tells a mirror,
/// zero (or less than rounding leaves) a transform that flattens.
double unit_determinant(const glm::dmat4& m) {
    glm::dmat3 axes(m);
    for (int i = 0; i < 3; ++i) {
        // Divided by the largest part first: squares of very small or large numbers leave the
        // range.
        const double largest = std::max({std::abs(axes[i].x), std::abs(axes[i].y), std::abs(axes[i].z)});
        if (largest == 0)
            return 0;
        axes[i] = glm::normalize(axes[i] / largest);
    }
    const double determinant = glm::determinant(axes);
    return std::abs(determinant) < 1e-12 ? 0 : determinant;
}

/// At least two axes that are not along one line: a flattened mesh still has faces.
bool spans_area(const glm::dmat4& m) {
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    const glm::dvec3 zero(0);
    return glm::cross(x, y) != zero || glm::cross(y, z) != zero || glm::cross(z, x) != zero;
}

bool finite_shape(const Deformation& made) {
    const auto finite = [](const glm::mat4& m) { return is_finite(glm::dmat4(m)); };
    const glm::vec3 sum = made.low + made.high;
    return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z) &&
           std::all_of(made.joints.begin(), made.joints.end(), finite) &&
           std::all_of(made.previous_joints.begin(), made.previous_joints.end(), finite);
}

/// The times at which nodes are wanted.
constexpr size_t now = 0, before = 1;

/// All nodes as they are at the moment, and as they were at its previous state.
NodeTree placed_nodes(const Scene& scene, uint32_t root, const std::optional<Moment>& moment,
                      const Channels& channels) {
    if (!moment)
        return {scene, root, Pose(scene)};
    const std::array times{moment->time, moment->time - moment->interval};
    return {scene, root, Pose(scene, channels, std::span(times).first(moment->interval != 0 ? 2 : 1))};
}

class Resolver {
public:
    Resolver(const Scene& scene, const std::vector<MeshFacts>& facts, uint32_t scene_index,
             const std::optional<Moment>& moment, NodeTree nodes, bool host_vertices)
        : scene_(scene), scene_index_(scene_index), host_vertices_(host_vertices), facts_(facts),
          nodes_(std::move(nodes)) {
        if (moment) {
            time_ = moment->time;
            interval_ = moment->interval;
        }
        world_.scene = &scene;
        world_.ambient = scene.ambient;
    }

    World run() {
        const SceneRoot& root = scene_.scenes[scene_index_];
        struct Step {
            uint32_t node;
            bool visible; ///< as far as its ancestors say
        };
        std::vector<Step> stack;
        const auto push = [&](const std::vector<uint32_t>& nodes, bool visible) {
            for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
                stack.push_back({*node, visible});
        };
        push(root.nodes, true);
        while (!stack.empty()) {
            const auto [index, above] = stack.back();
            stack.pop_back();
            const Node& node = scene_.nodes[index];
            for (size_t time = 0; time < nodes_.times(); ++time)
                check_finite(nodes_.world(index, time), index);
            const bool visible = above && node.visible;
            if (visible)
                show_contents(node, index);
            if (node.camera)
                add_camera(scene_.cameras[*node.camera], index);
            push(node.children, visible);
        }
        if (world_.triangles == 0)
            bounds_ = {glm::dvec3(0), glm::dvec3(0)};
        if (!bounds_.finite())
            throw Error(
                fmt::format("{}: scene {}: a vertex's world position is not finite", scene_.name, scene_index_));
        world_.lights.insert(world_.lights.end(), particle_lights_.begin(), particle_lights_.end());
        std::stable_sort(world_.decals.begin(), world_.decals.end(),
                         [](const PlacedDecal& a, const PlacedDecal& b) { return a.decal.order < b.decal.order; });
        world_.bounds_min = bounds_.min;
        world_.bounds_max = bounds_.max;
        add_defaults();
        return std::move(world_);
    }

private:
    /// Else nothing has moved.
    bool has_before() const { return nodes_.times() > before; }

    void check_finite(const glm::dmat4& transform, uint32_t node) const {
        if (!is_finite(transform))
            throw Error(fmt::format("{}: node {}: its world transform is not finite", scene_.name, node));
    }

    /// All that KHR_node_visibility may hide.
    void show_contents(const Node& node, uint32_t index) {
        const glm::dmat4& world = nodes_.world(index, now);
        if (node.mesh && facts_[*node.mesh].triangles > 0)
            show(node, index);
        if (node.light)
            world_.lights.push_back({scene_.lights[*node.light], glm::dvec3(world[3]),
                                     unit_or(-glm::dvec3(world[2]), {0, 0, -1}),
                                     unit_or(glm::dvec3(world[1]), {0, 1, 0})});
        if (node.emitter)
            add_particles(scene_.emitters[*node.emitter], index);
        if (node.decal && unit_determinant(world) != 0) // what is flat holds nothing
            world_.decals.push_back({scene_.decals[*node.decal], world});
    }

    void add_camera(const Camera& camera, uint32_t node) {
        PlacedCamera placed = place_camera(camera, nodes_.world(node, now));
        if (has_before()) {
            const PlacedCamera previous = place_camera(camera, nodes_.world(node, before));
            if (previous.position != placed.position || previous.axes != placed.axes)
                placed.previous = CameraPose{previous.position, previous.axes};
        }
        world_.cameras.push_back(placed);
    }

    /// The node's mesh in its shape, at the node or, with a skin, where the joints are.
    void show(const Node& node, uint32_t index) {
        const Mesh& mesh = scene_.meshes[*node.mesh];
        const bool skinned = node.skin && has_joints(mesh);
        const Shape shape = shape_of(node, index, skinned, now);
        const Shape previous = has_before() ? shape_of(node, index, skinned, before) : shape;
        Instance instance{.mesh = *node.mesh, .node = index, .receives_decals = node.receives_decals};
        glm::dvec3 origin(0);
        if (nodes_.weights_sampler(index) || !is_plain(mesh, shape) || !is_plain(mesh, previous))
            std::tie(instance.deformed, origin) = deformed(node, index, shape, previous);
        if (skinned) {
            instance.transform[3] = glm::dvec4(origin, 1);
            add_instance(instance);
            return;
        }
        const bool moved = has_before() && nodes_.world(index, before) != nodes_.world(index, now);
        const auto place = [&](const glm::dmat4& in_node) {
            instance.transform = nodes_.world(index, now) * in_node;
            if (moved)
                instance.previous_transform = nodes_.world(index, before) * in_node;
            add_instance(instance);
        };
        if (node.instances.empty())
            place(glm::dmat4(1));
        for (const glm::dmat4& in_node : node.instances)
            place(in_node);
    }

    Shape shape_of(const Node& node, uint32_t index, bool skinned, size_t time) {
        Shape shape{.weights = nodes_.weights(index, time)};
        if (skinned)
            shape.joints = nodes_.joints(*node.skin, time);
        return shape;
    }

    /// Index into World::deformed and the origin of its vertices; equal ones are made once. Weights that move make the
    /// same ones at every moment, whatever their values are: who shares a sampler, shares the mesh.
    std::pair<uint32_t, glm::dvec3> deformed(const Node& node, uint32_t index, const Shape& shape,
                                             const Shape& previous) {
        const std::optional<uint32_t> skin = shape.joints.empty() ? std::nullopt : node.skin;
        const AnimationSampler* const moving = nodes_.weights_sampler(index);
        const auto [found, is_new] =
            made_.try_emplace(moving ? Key{*node.mesh, skin, moving, {}, {}}
                                     : Key{*node.mesh, skin, moving, shape.weights, previous.weights});
        if (!is_new)
            return found->second;
        const Mesh& mesh = scene_.meshes[*node.mesh];
        const auto object = [&] { return fmt::format("{}: node {}", scene_.name, index); };
        const MeshFacts& facts = facts_[*node.mesh];
        if (skin && facts.joints > std::min(shape.joints.size(), previous.joints.size()))
            check_joints(mesh, std::min(shape.joints.size(), previous.joints.size()), object());
        auto [described, origin] = describe(mesh, *node.mesh, facts, shape, previous);
        const Deformation& made = world_.deformations.emplace_back(std::move(described));
        if (!host_vertices_ && !finite_shape(made)) // else each vertex is looked at
            throw Error(fmt::format("{}: it is deformed to a place that is not finite", object()));
        const uint64_t vertices = vertex_count(mesh), work = host_vertices_ ? deform_work(mesh) * nodes_.times() : 0;
        if (vertices > max_deformed_vertices - deformed_vertices_ || work > max_deform_work - deform_work_)
            throw Error(fmt::format("{}: the scene's skins and morph targets move more vertices than "
                                    "can be deformed ({} million, {} million steps)",
                                    object(), max_deformed_vertices >> 20, max_deform_work >> 20));
        deformed_vertices_ += vertices;
        deform_work_ += work;
        if (host_vertices_) {
            world_.deformed.push_back(
                deform(mesh, shape, has_before() ? &previous : nullptr, origin, made.turned, object()));
            deformed_boxes_.push_back(facts_of(world_.deformed.back()).box);
        } else {
            world_.deformed.push_back({.name = mesh.name, .primitives = {}});
            deformed_boxes_.push_back({glm::dvec3(made.low), glm::dvec3(made.high)});
        }
        found->second = {static_cast<uint32_t>(world_.deformed.size() - 1), origin};
        return found->second;
    }

    void add_instance(Instance instance) {
        const glm::dmat4& transform = instance.transform;
        check_finite(transform, instance.node);
        if (instance.previous_transform)
            check_finite(*instance.previous_transform, instance.node);
        if (!spans_area(transform)) // a line or a point: nothing to see
            return;
        instance.mirrored = unit_determinant(transform) < 0;
        world_.instances.push_back(instance);
        const MeshFacts& facts = facts_[instance.mesh];
        world_.triangles += facts.triangles;
        transformed_ += facts.vertices;
        const auto& primitives = world_.mesh_of(instance).primitives;
        if (transformed_ > max_exact_vertices || (instance.deformed && !host_vertices_)) {
            const Bounds box = instance.deformed ? deformed_boxes_[*instance.deformed] : facts.box;
            for (uint32_t i = 0; i < 8; ++i)
                add_point(transform, glm::dvec3(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                                                i & 4 ? box.max.z : box.min.z));
            return;
        }
        for (size_t p = 0; p < primitives.size(); ++p) {
            if (primitives[p].indices.empty())
                continue;
            const double reach = facing_reach(primitives[p]);
            if (facts.used[p].empty())
                for (const glm::vec3& position : primitives[p].positions)
                    add_point(transform, glm::dvec3(position), reach);
            for (uint32_t i : facts.used[p])
                add_point(transform, glm::dvec3(primitives[p].positions[i]), reach);
        }
    }

    /// Lights and shapes of an emitter's particles.
    void add_particles(const Emitter& emitter, uint32_t node) {
        if (uint64_t(6) * emitter.count > max_deformed_vertices - deformed_vertices_)
            throw Error(
                fmt::format("{}: node {}: the scene's emitters have more particles than fit", scene_.name, node));
        deformed_vertices_ += uint64_t(6) * emitter.count;
        Emission emission = emit(emitter, nodes_.world(node, now), time_,
                                 has_before() ? std::optional(nodes_.world(node, before)) : std::nullopt, interval_,
                                 fmt::format("{}: node {}", scene_.name, node));
        particle_lights_.insert(particle_lights_.end(), emission.lights.begin(), emission.lights.end());
        if (!emission.shapes)
            return;
        Instance instance{
            .node = node, .deformed = static_cast<uint32_t>(world_.deformed.size()), .receives_decals = false};
        instance.transform[3] = glm::dvec4(emission.origin, 1);
        const double reach = facing_reach(*emission.shapes);
        for (const glm::vec3& position : emission.shapes->positions)
            add_point(instance.transform, glm::dvec3(position), reach);
        world_.triangles += emission.shapes->indices.size() / 3;
        world_.instances.push_back(instance);
        world_.deformations.emplace_back();
        Mesh& mesh = world_.deformed.emplace_back();
        mesh.name = "particles";
        mesh.primitives.push_back(std::move(*emission.shapes));
        deformed_boxes_.push_back(facts_of(mesh).box);
    }

    /// And metres around it.
    void add_point(const glm::dmat4& transform, glm::dvec3 p, double around = 0) {
        const glm::dvec3 place(transform * glm::dvec4(p, 1));
        bounds_.add(place - around);
        if (around > 0)
            bounds_.add(place + around);
    }

    void add_defaults() {
        if (world_.cameras.empty() && host_vertices_) {
            const std::optional<PlacedCamera> inside = camera_inside(world_);
            world_.framed = !inside;
            world_.cameras.push_back(inside ? *inside : frame(world_, 1));
        }
        if (!is_lit(scene_, scene_index_)) {
            PlacedLight key;
            key.light.name = "key";
            key.light.kind = LightKind::directional;
            key.light.intensity = 3;
            key.direction = glm::normalize(glm::dvec3(-0.4, -0.8, -0.45));
            world_.lights.push_back(key);
            world_.ambient = glm::vec3(0.25f);
        }
    }

    const Scene& scene_;
    uint32_t scene_index_;
    bool host_vertices_;                  ///< fill World::deformed; else only what makes them
    const std::vector<MeshFacts>& facts_; ///< by mesh
    NodeTree nodes_;
    /// Mesh, skin, what moves its weights, and weights now and before where nothing does.
    using Key = std::tuple<uint32_t, std::optional<uint32_t>, const AnimationSampler*, std::vector<double>,
                           std::vector<double>>;
    std::map<Key, std::pair<uint32_t, glm::dvec3>> made_; ///< index into World::deformed, origin
    double time_ = 0, interval_ = 0;                      ///< of the moment, seconds
    std::vector<PlacedLight> particle_lights_;
    std::vector<Bounds> deformed_boxes_; ///< beside World::deformed, object space
    World world_;
    Bounds bounds_;
    uint64_t transformed_ = 0, deformed_vertices_ = 0, deform_work_ = 0;
};

} // namespace

World resolve(const Scene& scene, const std::vector<MeshFacts>& facts, const Channels& channels,
              std::optional<uint32_t> scene_index, const std::optional<Moment>& moment, bool host_vertices) {
    const uint32_t index = scene_index.value_or(scene.default_scene);
    if (index >= scene.scenes.size())
        throw Error(fmt::format("{}: scene {}: the file has {}", scene.name, index, scene.scenes.size()));
    return Resolver(scene, facts, index, moment, placed_nodes(scene, index, moment, channels), host_vertices).run();
}

World resolve(const Scene& scene, std::optional<uint32_t> scene_index, const std::optional<Moment>& moment,
              std::optional<uint32_t> animation) {
    const Channels channels = moment ? Channels(scene, animation) : Channels();
    return resolve(scene, facts_of(scene), channels, scene_index, moment, true);
}

} // namespace prelight
