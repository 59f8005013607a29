#include <algorithm>
#include <prelight/timeline.hpp>
#include <scene/animate.hpp>
#include <scene/mesh_facts.hpp>
#include <utility>

namespace prelight {
namespace {

bool same_triangles(const Mesh& a, const Mesh& b) {
    return std::equal(
        a.primitives.begin(), a.primitives.end(), b.primitives.begin(), b.primitives.end(),
        [](const Primitive& x, const Primitive& y) { return x.indices == y.indices && x.material == y.material; });
}

const Deformation& shape_of(const World& world, uint32_t deformed) {
    static const Deformation none;
    return deformed < world.deformations.size() ? world.deformations[deformed] : none;
}

/// Other draws: not a change in place.
bool same_draws(const World& a, const World& b) {
    const auto same = [](const Instance& x, const Instance& y) {
        return x.mesh == y.mesh && x.node == y.node && x.deformed == y.deformed &&
               x.receives_decals == y.receives_decals;
    };
    return std::equal(a.instances.begin(), a.instances.end(), b.instances.begin(), b.instances.end(), same) &&
           std::equal(a.deformed.begin(), a.deformed.end(), b.deformed.begin(), b.deformed.end(), same_triangles);
}

bool same_place(const Instance& a, const Instance& b) {
    return a.transform == b.transform && a.previous_transform == b.previous_transform && a.mirrored == b.mirrored &&
           a.visible == b.visible;
}

bool same_vertices(const Primitive& a, const Primitive& b) {
    return a.positions == b.positions && a.previous_positions == b.previous_positions && a.normals == b.normals &&
           a.tangents == b.tangents && a.colours == b.colours && a.texcoords == b.texcoords && a.facing == b.facing;
}

bool same_shape(const Mesh& a, const Mesh& b) {
    return std::equal(a.primitives.begin(), a.primitives.end(), b.primitives.begin(), b.primitives.end(),
                      same_vertices);
}

bool same_light(const PlacedLight& a, const PlacedLight& b) {
    return a.position == b.position && a.direction == b.direction && a.up == b.up && a.light == b.light;
}

bool same_decal(const PlacedDecal& a, const PlacedDecal& b) { return a.decal == b.decal && a.transform == b.transform; }

template <class T, class Same>
bool differ(const std::vector<T>& a, const std::vector<T>& b, Same same) {
    return !std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

} // namespace

WorldChanges become(World& now, World&& next) {
    WorldChanges changes;
    if (!same_draws(now, next)) {
        now = std::move(next);
        changes.all = changes.lights = true;
        return changes;
    }
    for (uint32_t i = 0; i < now.instances.size(); ++i)
        if (!same_place(now.instances[i], next.instances[i])) {
            now.instances[i] = next.instances[i];
            changes.instances.push_back(i);
        }
    for (uint32_t d = 0; d < now.deformed.size(); ++d)
        if (shape_of(now, d) != shape_of(next, d) || !same_shape(now.deformed[d], next.deformed[d])) {
            now.deformed[d] = std::move(next.deformed[d]);
            changes.deformed.push_back(d);
        }
    now.deformations = std::move(next.deformations);
    changes.lights = differ(now.lights, next.lights, same_light);
    if (changes.lights)
        now.lights = std::move(next.lights);
    changes.decals = differ(now.decals, next.decals, same_decal);
    if (changes.decals)
        now.decals = std::move(next.decals);
    now.cameras = std::move(next.cameras);
    now.framed = next.framed;
    now.ambient = next.ambient;
    now.bounds_min = next.bounds_min;
    now.bounds_max = next.bounds_max;
    now.triangles = next.triangles;
    return changes;
}

void WorldChanges::add(const WorldChanges& more) {
    const auto append = [](std::vector<uint32_t>& to, const std::vector<uint32_t>& from) {
        to.insert(to.end(), from.begin(), from.end());
        std::sort(to.begin(), to.end());
        to.erase(std::unique(to.begin(), to.end()), to.end());
    };
    all = all || more.all;
    lights = lights || more.lights;
    decals = decals || more.decals;
    append(instances, more.instances);
    append(deformed, more.deformed);
    append(materials, more.materials);
}

struct Timeline::State {
    const Scene& scene;
    std::optional<uint32_t> scene_index;
    bool host_vertices;
    std::vector<MeshFacts> facts;
    Channels channels;
    World world;
};

Timeline::Timeline(const Scene& scene, std::optional<uint32_t> scene_index, const std::optional<Moment>& moment,
                   std::optional<uint32_t> animation, bool host_vertices)
    : state_(new State{scene, scene_index, host_vertices, facts_of(scene), Channels(scene, animation), {}}) {
    World& world = state_->world;
    world = resolve(scene, state_->facts, state_->channels, scene_index, moment, true);
    if (host_vertices)
        return;
    World boxes = resolve(scene, state_->facts, state_->channels, scene_index, moment, false);
    boxes.cameras = std::move(world.cameras); // which may have been found by vertices
    boxes.framed = world.framed;
    boxes.bounds_min = world.bounds_min;
    boxes.bounds_max = world.bounds_max;
    world = std::move(boxes);
}
Timeline::~Timeline() = default;
Timeline::Timeline(Timeline&&) noexcept = default;
Timeline& Timeline::operator=(Timeline&&) noexcept = default;

const World& Timeline::world() const { return state_->world; }

bool Timeline::moves() const {
    const Scene& scene = state_->scene;
    return !scene.animations.empty() || !scene.emitters.empty();
}

World Timeline::at(const Moment& moment) const {
    return resolve(state_->scene, state_->facts, state_->channels, state_->scene_index, moment, state_->host_vertices);
}

WorldChanges Timeline::move_to(const Moment& moment) { return take(at(moment)); }

WorldChanges Timeline::take(World&& next) {
    if (next.cameras.empty()) { // the scene has none: the first one stays
        next.cameras = state_->world.cameras;
        next.framed = state_->world.framed;
    }
    return become(state_->world, std::move(next));
}

} // namespace prelight
