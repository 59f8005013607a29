#include <algorithm>
#include <cmath>
#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <prelight/error.hpp>
#include <prelight/material_shader.hpp>
#include <reference/passed_surfaces.hpp>
#include <reference/ray_scene.hpp>

namespace prelight::reference {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Embree hands this to the filter with every ray.
struct Context {
    RTCIntersectContext embree; // first, so that the pointers are the same
    const RayScene* scene;
    bool both_faces = false;                  ///< of single-sided materials too
    bool meets_layers = false;                ///< as if they were opaque
    bool meets_nothing = false;               ///< it goes through all, and `crossed` tells of layers
    std::vector<Hole>* holes = nullptr;       ///< where what alpha tests let pass is told
    std::vector<Crossing>* crossed = nullptr; ///< likewise layers
};

/// As the camera sees it: vertices in the world's axes, relative to the origin of `to_world` and `previous`.
Primitive faced(Primitive primitive, const glm::dmat3& to_world, const glm::dmat3& previous, const glm::dmat3& viewer) {
    for (size_t v = 0; v < primitive.positions.size(); ++v) {
        const glm::dvec3 offset = viewer * glm::dvec3(primitive.facing[v], 0);
        primitive.positions[v] = glm::vec3(to_world * glm::dvec3(primitive.positions[v]) + offset);
        if (!primitive.previous_positions.empty())
            primitive.previous_positions[v] =
                glm::vec3(previous * glm::dvec3(primitive.previous_positions[v]) + offset);
        primitive.normals[v] = glm::vec3(viewer * glm::dvec3(primitive.normals[v]));
        if (!primitive.tangents.empty())
            primitive.tangents[v] = glm::vec4(viewer * glm::dvec3(primitive.tangents[v]), primitive.tangents[v].w);
    }
    return primitive;
}

/// Without what turns and stretches.
glm::dmat4 moved_only(const glm::dmat4& transform) {
    glm::dmat4 out(1);
    out[3] = transform[3];
    return out;
}

/// Inverse transpose without dividing by the determinant, which a flat scale makes zero.
glm::dmat3 normal_matrix(const glm::dmat3& m, bool mirrored) {
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return mirrored ? -cofactors : cofactors;
}

RTCRay to_embree(const Ray& ray) {
    RTCRay out{};
    out.org_x = static_cast<float>(ray.origin.x);
    out.org_y = static_cast<float>(ray.origin.y);
    out.org_z = static_cast<float>(ray.origin.z);
    out.dir_x = static_cast<float>(ray.direction.x);
    out.dir_y = static_cast<float>(ray.direction.y);
    out.dir_z = static_cast<float>(ray.direction.z);
    out.tnear = static_cast<float>(ray.near);
    out.tfar = static_cast<float>(ray.far);
    out.mask = 0xffffffffu;
    return out;
}

/// A triangle relative to the scene's origin, in double precision.
struct Triangle {
    glm::dvec3 corner[3], edge1{}, edge2{}, across{};
    Triangle(const Draw& draw, uint32_t triangle) {
        const uint32_t* index = &draw.primitive->indices[size_t(triangle) * 3];
        for (int i = 0; i < 3; ++i)
            corner[i] = glm::dvec3(draw.to_world * glm::dvec4(draw.primitive->positions[index[i]], 1));
        edge1 = corner[1] - corner[0];
        edge2 = corner[2] - corner[0];
        across = glm::cross(edge1, edge2);
    }
    glm::dvec3 at(glm::dvec2 place) const { return corner[0] + place.x * edge1 + place.y * edge2; }
    /// Where the ray meets its plane: weights of the second and third corner, and how far along the ray.
    glm::dvec2 meet(const Ray& ray, double& distance) const {
        distance = glm::dot(across, corner[0] - ray.origin) / glm::dot(across, ray.direction);
        const glm::dvec3 inside = ray.origin + distance * ray.direction - corner[0];
        return glm::dvec2(glm::dot(glm::cross(inside, edge2), across), glm::dot(glm::cross(edge1, inside), across)) /
               glm::dot(across, across);
    }
};

} // namespace

struct RayScene::Embree {
    // One thread: the tree, and with it the choice between two equal hits, is the same every time.
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = device ? rtcNewScene(device) : nullptr;

    Embree() { check(); }
    ~Embree() {
        if (scene)
            rtcReleaseScene(scene);
        if (device)
            rtcReleaseDevice(device);
    }
    Embree(const Embree&) = delete;
    Embree& operator=(const Embree&) = delete;
    void check() const {
        const RTCError error = rtcGetDeviceError(device);
        if (error == RTC_ERROR_OUT_OF_MEMORY)
            throw Error("reference: Embree: out of memory");
        if (!device || !scene || error != RTC_ERROR_NONE)
            throw Error(fmt::format("reference: Embree: error {}", static_cast<int>(error)));
    }
};

RayScene::RayScene(const World& world, glm::dvec3 origin, const Textures& textures, Transparency transparency,
                   TransparentShadows transparent_shadows, const glm::dmat3& viewer)
    : textures_(textures), transparency_(transparency), transparent_shadows_(transparent_shadows),
      embree_(std::make_unique<Embree>()) {
    const Scene& scene = *world.scene;
    rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);
    for (uint32_t i = 0; i < world.instances.size(); ++i) {
        const Instance& instance = world.instances[i];
        if (!instance.visible)
            continue;
        glm::dmat4 to_world = instance.transform;
        to_world[3] -= glm::dvec4(origin, 0);
        const glm::dmat3 linear(to_world);
        const bool mirrored = glm::determinant(linear) < 0;
        const Mesh& mesh = world.mesh_of(instance);
        glm::dmat4 previous_to_world = instance.previous_transform.value_or(instance.transform);
        previous_to_world[3] -= glm::dvec4(origin, 0);
        for (uint32_t p = 0; p < mesh.primitives.size(); ++p) {
            const Primitive& primitive = mesh.primitives[p];
            const Material& material = scene.materials.at(primitive.material);
            const bool transmissive = transparency == Transparency::layers && prelight::transmits(material);
            if (primitive.facing.empty()) {
                draws_.push_back({i, p, &primitive, &material, to_world, previous_to_world,
                                  normal_matrix(linear, mirrored), mirrored, transmissive});
                continue;
            }
            const Primitive& seen =
                faced_.emplace_back(faced(primitive, linear, glm::dmat3(previous_to_world), viewer));
            draws_.push_back({i, p, &seen, &material, moved_only(to_world), moved_only(previous_to_world),
                              glm::dmat3(1), false, transmissive});
        }
    }
    for (const Draw& draw : draws_) {
        add(draw, world);
        has_layers_ = has_layers_ || is_layer(draw);
        transmits_ = transmits_ || draw.transmissive;
    }
    rtcCommitScene(embree_->scene);
    embree_->check();
}

RayScene::~RayScene() = default;

void RayScene::add(const Draw& draw, const World& world) {
    const Primitive& primitive = *draw.primitive;
    const size_t vertices = primitive.positions.size(), triangles = primitive.indices.size() / 3;
    for (const uint32_t index : primitive.indices)
        if (index >= vertices)
            throw Error(fmt::format("{}: mesh {}: primitive {}: index {} is beyond its {} vertices", world.scene->name,
                                    world.instances[draw.instance].mesh, draw.primitive_index, index, vertices));
    for (const TextureRef* ref :
         {&draw.material->base_colour_texture, &draw.material->metallic_roughness_texture,
          &draw.material->normal_texture, &draw.material->occlusion_texture, &draw.material->emissive_texture})
        if (*ref && (ref->image >= world.scene->images.size() || world.scene->images[ref->image].rgba.empty()))
            throw Error(fmt::format("{}: material {}: image {} is not there", world.scene->name, draw.material->name,
                                    ref->image));
    for (const auto& [name, ref] : draw.material->textures)
        if (ref && (ref.image >= world.scene->images.size() || world.scene->images[ref.image].rgba.empty()))
            throw Error(fmt::format("{}: material {}: image {} is not there", world.scene->name, draw.material->name,
                                    ref.image));
    if (triangles == 0)
        return;

    const RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* out = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices));
    auto* indices = static_cast<uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(uint32_t), triangles));
    if (out && indices) {
        for (const glm::vec3& position : primitive.positions) {
            const glm::dvec3 world_position(draw.to_world * glm::dvec4(position, 1));
            for (int axis = 0; axis < 3; ++axis)
                *out++ = static_cast<float>(world_position[axis]);
        }
        std::copy_n(primitive.indices.begin(), triangles * 3, indices);
        rtcSetGeometryIntersectFilterFunction(geometry, filter);
        if (draw.material->alpha_mode == AlphaMode::mask || is_layer(draw))
            rtcSetGeometryOccludedFilterFunction(geometry, filter);
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(embree_->scene, geometry, static_cast<unsigned>(&draw - draws_.data()));
    }
    rtcReleaseGeometry(geometry);
    embree_->check();
}

bool RayScene::masked_out(const Draw& draw, uint32_t triangle, glm::dvec2 place) const {
    if (draw.material->alpha_mode != AlphaMode::mask)
        return false;
    Hit tested;
    tested.draw = static_cast<uint32_t>(&draw - draws_.data());
    tested.triangle = triangle;
    tested.weights = {1 - place.x - place.y, place.x, place.y};
    return base_colour(tested).a < static_cast<double>(draw.material->alpha_cutoff);
}

void RayScene::filter(const RTCFilterFunctionNArguments* arguments) {
    const auto& context = *reinterpret_cast<const Context*>(arguments->context);
    const auto& ray = *reinterpret_cast<const RTCRay*>(arguments->ray);
    const auto& hit = *reinterpret_cast<const RTCHit*>(arguments->hit);
    const Draw& draw = context.scene->draws_[hit.geomID];
    const float against = hit.Ng_x * ray.dir_x + hit.Ng_y * ray.dir_y + hit.Ng_z * ray.dir_z;

    if (!context.both_faces && !draw.material->double_sided && (draw.mirrored ? against <= 0 : against >= 0)) {
        arguments->valid[0] = 0;
        return;
    }
    if (context.scene->is_layer(draw) && (!context.meets_layers || draw.transmissive)) {
        arguments->valid[0] = 0;
        if (context.crossed && !context.scene->masked_out(draw, hit.primID, {hit.u, hit.v}))
            context.crossed->push_back({ray.tfar, hit.geomID, hit.primID, {hit.u, hit.v}, against > 0});
        return;
    }
    if (context.meets_nothing)
        arguments->valid[0] = 0;
    if (context.meets_nothing || !context.scene->masked_out(draw, hit.primID, {hit.u, hit.v}))
        return;
    arguments->valid[0] = 0;
    if (context.holes)
        context.holes->push_back({ray.tfar, hit.geomID});
}

bool RayScene::closest(const Ray& ray, Hit& hit, std::vector<Hit>* layers) const {
    std::vector<Hole> holes;
    Context context{.embree = {}, .scene = this, .holes = &holes};
    rtcInitIntersectContext(&context.embree);
    RTCRayHit query{to_embree(ray), {}};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(embree_->scene, &context.embree, &query);

    const bool found = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    hit = {};
    hit.mask_outcome = hash_of(holes, found ? double(query.ray.tfar) : infinity);
    if (!found) {
        if (layers)
            *layers = layers_until(ray, infinity);
        return false;
    }
    hit.draw = query.hit.geomID;
    hit.triangle = query.hit.primID;
    if (draws_[hit.draw].material->alpha_mode == AlphaMode::mask)
        hit.mask_outcome += scattered(hit.draw * uint64_t(2) + 1);
    refine(ray, hit, {query.hit.u, query.hit.v}, query.ray.tfar);
    if (layers)
        *layers = layers_until(ray, hit.distance);
    return true;
}

std::vector<Hit> RayScene::layers_until(const Ray& ray, double limit) const {
    std::vector<Hit> layers;
    if (!has_layers_)
        return layers;
    // By itself, and somewhat farther: the search for the hit may have ended before a layer that lies on it.
    std::vector<Crossing> crossed;
    Context context{.embree = {}, .scene = this, .meets_nothing = true, .crossed = &crossed};
    rtcInitIntersectContext(&context.embree);
    RTCRayHit query{to_embree({ray.origin, ray.direction, ray.near, std::min(ray.far, limit * 1.00001)}), {}};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(embree_->scene, &context.embree, &query);
    leave_one_each(crossed, draws_);
    for (const Crossing& one : crossed) {
        Hit& hit = layers.emplace_back();
        hit.draw = one.draw;
        hit.triangle = one.triangle;
        refine(ray, hit, one.place, one.distance);
    }
    front_to_back(layers, limit);
    const auto last =
        std::find_if(layers.begin(), layers.end(), [&](const Hit& one) { return draws_[one.draw].transmissive; });
    if (last != layers.end())
        layers.erase(last + 1, layers.end());
    return layers;
}

void RayScene::refine(const Ray& ray, Hit& hit, glm::dvec2 embree_weights, double embree_distance) const {
    const Draw& draw = draws_[hit.draw];
    const Triangle triangle(draw, hit.triangle);
    double extent = 0;
    for (const glm::dvec3& corner : triangle.corner)
        for (int axis = 0; axis < 3; ++axis)
            extent = std::max(extent, std::abs(corner[axis]));
    const double facing = glm::dot(triangle.across, ray.direction);

    glm::dvec2 place = embree_weights;
    hit.distance = embree_distance;
    // The ray against the triangle's plane, in double. A ray along the plane or a needle of a
    // triangle throws the point out of it: Embree's own answer is the better one then.
    double distance = 0;
    const glm::dvec2 exact = triangle.meet(ray, distance);
    constexpr double slack = 1e-3;
    if (exact.x > -slack && exact.y > -slack && exact.x + exact.y < 1 + slack) {
        place = exact;
        hit.distance = distance;
    }
    hit.weights = {1 - place.x - place.y, place.x, place.y};
    hit.position = triangle.at(place);
    hit.geometric_normal = glm::normalize(facing > 0 ? -triangle.across : triangle.across);
    hit.back = draw.material->double_sided && (facing > 0) != draw.mirrored;
    // Thirty times the rounding of the farthest corner to float.
    hit.offset = extent * 2e-6;
}

Hit RayScene::beside(const Hit& hit, const Ray& ray) const {
    const Triangle triangle(draws_[hit.draw], hit.triangle);
    Hit out = hit;
    const glm::dvec2 place = triangle.meet(ray, out.distance);
    out.weights = {1 - place.x - place.y, place.x, place.y};
    out.position = triangle.at(place);
    return out;
}

Passage RayScene::passage(const Ray& ray) const {
    std::vector<Crossing> crossed;
    Context context{.embree = {},
                    .scene = this,
                    .both_faces = true,
                    .meets_layers = transparent_shadows_ == TransparentShadows::opaque,
                    .crossed = transparent_shadows_ == TransparentShadows::filtered ? &crossed : nullptr};
    rtcInitIntersectContext(&context.embree);
    RTCRay query = to_embree(ray);
    rtcOccluded1(embree_->scene, &context.embree, &query);
    if (query.tfar < 0) // Embree's sign for "something there"
        return {.transmittance = 0};
    Passage passage;
    leave_one_each(crossed, draws_);
    for (const Crossing& one : crossed) {
        if (draws_[one.draw].transmissive)
            continue;
        Hit hit;
        hit.draw = one.draw;
        hit.triangle = one.triangle;
        hit.weights = {1 - one.place.x - one.place.y, one.place.x, one.place.y};
        passage.transmittance *= 1 - std::clamp(base_colour(hit).a, 0.0, 1.0);
        passage.crossed += scattered(one.draw + uint64_t(1));
    }
    return passage;
}

double RayScene::blocked_at(const Ray& ray) const {
    Context context{.embree = {}, .scene = this, .both_faces = true};
    rtcInitIntersectContext(&context.embree);
    RTCRayHit query{to_embree(ray), {}};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(embree_->scene, &context.embree, &query);
    return query.hit.geomID == RTC_INVALID_GEOMETRY_ID ? infinity : double(query.ray.tfar);
}

glm::dvec4 RayScene::base_colour(const Hit& hit, const TexcoordShift& shift, const Beside* beside) const {
    const Draw& draw = draws_[hit.draw];
    const Material& material = *draw.material;
    glm::dvec4 colour = material.base_colour;
    if (const TextureRef& ref = material.base_colour_texture)
        colour *=
            textures_.sample(ref, texcoords(draw, hit.triangle, hit.weights, ref.texcoord) + shift[ref.texcoord & 1],
                             Encoding::srgb, footprint(draw, hit, beside, ref.texcoord));
    if (!draw.primitive->colours.empty())
        colour *= interpolate(draw.primitive->colours, draw, hit.triangle, hit.weights);
    return colour;
}

} // namespace prelight::reference
