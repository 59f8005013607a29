#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <prelight/error.hpp>
#include <prelight/scene.hpp>
#include <scene/enclosure.hpp>
#include <scene/finite.hpp>

namespace prelight {
namespace {

/// Vertex transforms that bounds may cost; beyond it a mesh's box stands for its vertices, so that
/// a file with a million instances of a million vertices cannot stall the program.
constexpr uint64_t max_exact_vertices = uint64_t(1) << 25;

struct Bounds {
    glm::dvec3 min{std::numeric_limits<double>::infinity()};
    glm::dvec3 max{-std::numeric_limits<double>::infinity()};
    void add(glm::dvec3 p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    bool finite() const {
        const glm::dvec3 sum = min + max;
        return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z);
    }
};

/// What the walk needs of a mesh, gathered once.
struct MeshFacts {
    uint64_t triangles = 0;
    uint64_t vertices = 0;                   ///< that a triangle uses
    std::vector<std::vector<uint32_t>> used; ///< per primitive, sorted; empty: every vertex
    Bounds box;                              ///< object space
};

MeshFacts facts_of(const Mesh& mesh) {
    MeshFacts facts;
    for (const Primitive& primitive : mesh.primitives) {
        facts.triangles += primitive.indices.size() / 3;
        std::vector<bool> seen(primitive.positions.size());
        for (uint32_t index : primitive.indices)
            seen[index] = true;
        auto& used = facts.used.emplace_back();
        const auto count = size_t(std::count(seen.begin(), seen.end(), true));
        facts.vertices += count;
        for (uint32_t i = 0; i < seen.size(); ++i) {
            if (!seen[i])
                continue;
            facts.box.add(glm::dvec3(primitive.positions[i]));
            if (count != seen.size())
                used.push_back(i);
        }
    }
    return facts;
}

/// Determinant of the linear part with each axis scaled to unit length: its sign tells a mirror,
/// zero (or less than rounding leaves) a transform that flattens.
double unit_determinant(const glm::dmat4& m) {
    glm::dmat3 axes(m);
    for (int i = 0; i < 3; ++i) {
        // Divided by the largest part first: squares of very small or large numbers leave the
        // range.
        const double largest =
            std::max({std::abs(axes[i].x), std::abs(axes[i].y), std::abs(axes[i].z)});
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

glm::dvec3 unit_or(glm::dvec3 v, glm::dvec3 fallback) {
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    return largest > 0 ? glm::normalize(v / largest) : fallback;
}

PlacedCamera place_camera(const Camera& camera, const glm::dmat4& world) {
    const glm::dvec3 back = unit_or(glm::dvec3(world[2]), {0, 0, 1});
    glm::dvec3 up = unit_or(glm::dvec3(world[1]), {0, 1, 0});
    up -= back * glm::dot(up, back);
    if (glm::length(up) < 1e-9) // flattened: any up will do
        up = glm::cross(back, std::abs(back.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    up = glm::normalize(up);
    return {camera, glm::dvec3(world[3]), glm::dmat3(glm::cross(up, back), up, back)};
}

/// Sees every corner of the bounds in a picture that is at least as wide as high.
PlacedCamera framed_camera(glm::dvec3 low, glm::dvec3 high) {
    Camera camera;
    camera.name = "framed";
    camera.yfov = 0.87;
    const glm::dvec3 centre = 0.5 * low + 0.5 * high;
    glm::dvec3 half = 0.5 * high - 0.5 * low;
    if (half == glm::dvec3(0))
        half = glm::dvec3(0.5);
    PlacedCamera placed = look_at(camera, centre + glm::dvec3(1, 0.6, 1.4), centre);
    placed.axes = look_at(camera, {1, 0.6, 1.4}, {0, 0, 0}).axes; // exact however far the centre is
    const double tangent = std::tan(camera.yfov / 2);
    double distance = 0, nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    std::array<glm::dvec3, 8> corners;
    for (uint32_t i = 0; i < 8; ++i) {
        const glm::dvec3 sign(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        corners[i] = glm::transpose(placed.axes) * (half * sign);
        const double extent = std::max(std::abs(corners[i].x), std::abs(corners[i].y));
        distance = std::max(distance, corners[i].z + 1.02 * extent / tangent);
    }
    for (const glm::dvec3& corner : corners) {
        nearest = std::min(nearest, distance - corner.z);
        farthest = std::max(farthest, distance - corner.z);
    }
    placed.camera.zfar = 1.5 * farthest;
    placed.camera.znear = std::max(0.5 * nearest, 1e-4 * farthest);
    placed.position = centre + placed.axes[2] * distance;
    return placed;
}

class Resolver {
public:
    explicit Resolver(const Scene& scene) : scene_(scene) {
        world_.scene = &scene;
        world_.ambient = scene.ambient;
        for (const Mesh& mesh : scene.meshes)
            facts_.push_back(facts_of(mesh));
    }

    World run(uint32_t scene_index) {
        const SceneRoot& root = scene_.scenes[scene_index];
        struct Entry {
            uint32_t node;
            glm::dmat4 parent;
        };
        // A stack of our own: a chain of a million nodes must not exhaust the program's.
        std::vector<Entry> stack;
        for (auto it = root.nodes.rbegin(); it != root.nodes.rend(); ++it)
            stack.push_back({*it, glm::dmat4(1)});
        while (!stack.empty()) {
            const Entry entry = stack.back();
            stack.pop_back();
            const Node& node = scene_.nodes[entry.node];
            const glm::dmat4 world = entry.parent * node.local;
            check_finite(world, entry.node);
            visit(node, entry.node, world);
            for (auto it = node.children.rbegin(); it != node.children.rend(); ++it)
                stack.push_back({*it, world});
        }
        if (world_.triangles == 0)
            throw Error(fmt::format("{}: scene {}: no triangles", scene_.name, scene_index));
        if (!bounds_.finite())
            throw Error(fmt::format("{}: scene {}: a vertex's world position is not finite",
                                    scene_.name, scene_index));
        world_.bounds_min = bounds_.min;
        world_.bounds_max = bounds_.max;
        add_defaults();
        return std::move(world_);
    }

private:
    void check_finite(const glm::dmat4& transform, uint32_t node) const {
        if (!is_finite(transform))
            throw Error(
                fmt::format("{}: node {}: its world transform is not finite", scene_.name, node));
    }

    void visit(const Node& node, uint32_t index, const glm::dmat4& world) {
        if (node.mesh && facts_[*node.mesh].triangles > 0) {
            if (node.instances.empty())
                add_instance(*node.mesh, index, world);
            for (const glm::dmat4& instance : node.instances)
                add_instance(*node.mesh, index, world * instance);
        }
        if (node.camera)
            world_.cameras.push_back(place_camera(scene_.cameras[*node.camera], world));
        if (node.light)
            world_.lights.push_back({scene_.lights[*node.light], glm::dvec3(world[3]),
                                     unit_or(-glm::dvec3(world[2]), {0, 0, -1})});
    }

    void add_instance(uint32_t mesh, uint32_t node, const glm::dmat4& transform) {
        check_finite(transform, node);
        if (!spans_area(transform)) // a line or a point: nothing to see
            return;
        const double determinant = unit_determinant(transform);
        world_.instances.push_back({mesh, transform, determinant < 0, node});
        const MeshFacts& facts = facts_[mesh];
        world_.triangles += facts.triangles;
        transformed_ += facts.vertices;
        if (transformed_ > max_exact_vertices) {
            for (uint32_t i = 0; i < 8; ++i)
                add_point(transform, glm::dvec3(i & 1 ? facts.box.max.x : facts.box.min.x,
                                                i & 2 ? facts.box.max.y : facts.box.min.y,
                                                i & 4 ? facts.box.max.z : facts.box.min.z));
            return;
        }
        const auto& primitives = scene_.meshes[mesh].primitives;
        for (size_t p = 0; p < primitives.size(); ++p) {
            if (primitives[p].indices.empty())
                continue;
            if (facts.used[p].empty())
                for (const glm::vec3& position : primitives[p].positions)
                    add_point(transform, glm::dvec3(position));
            for (uint32_t i : facts.used[p])
                add_point(transform, glm::dvec3(primitives[p].positions[i]));
        }
    }

    void add_point(const glm::dmat4& transform, glm::dvec3 p) {
        bounds_.add(glm::dvec3(transform * glm::dvec4(p, 1)));
    }

    void add_defaults() {
        if (world_.cameras.empty())
            world_.cameras.push_back(camera_inside(world_).value_or(
                framed_camera(world_.bounds_min, world_.bounds_max)));
        if (world_.lights.empty() && world_.ambient == glm::vec3(0)) {
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
    std::vector<MeshFacts> facts_;
    World world_;
    Bounds bounds_;
    uint64_t transformed_ = 0;
};

} // namespace

World resolve(const Scene& scene, std::optional<uint32_t> scene_index,
              const std::optional<Moment>& /*moment*/, std::optional<uint32_t> /*animation*/) {
    const uint32_t index = scene_index.value_or(scene.default_scene);
    if (index >= scene.scenes.size())
        throw Error(
            fmt::format("{}: scene {}: the file has {}", scene.name, index, scene.scenes.size()));
    return Resolver(scene).run(index);
}

} // namespace prelight
