#include "deformation.hpp"
#include <bit>
#include <fmt/format.h>
#include <map>
#include <prelight/error.hpp>

namespace prelight::resident {
namespace {

/// Where the data of one primitive at rest begin.
struct AtRest {
    uint32_t vertices = 0, influences = 0, targets = 0;
};

/// Primitives at rest, each once.
class Meshes {
public:
    const AtRest& find(const Primitive& primitive) {
        const auto [found, is_new] = known_.try_emplace(&primitive);
        if (is_new) {
            found->second = {static_cast<uint32_t>(base.size() / DEFORM_BASE_FLOATS),
                             static_cast<uint32_t>(influences.size()), static_cast<uint32_t>(targets.size())};
            for (uint32_t v = 0; v < primitive.positions.size(); ++v)
                add_vertex(primitive, v);
            for (const MorphTarget& target : primitive.morph_targets)
                for (uint32_t v = 0; v < primitive.positions.size(); ++v)
                    for (const auto* list : {&target.positions, &target.normals, &target.tangents})
                        add(targets, v < list->size() ? (*list)[v] : glm::vec3(0));
        }
        return found->second;
    }

    std::vector<float> base;
    std::vector<uint32_t> influences;
    std::vector<float> targets;

private:
    static void add(std::vector<float>& out, const glm::vec3& v) { out.insert(out.end(), {v.x, v.y, v.z}); }

    void add_vertex(const Primitive& primitive, uint32_t v) {
        add(base, primitive.positions[v]);
        add(base, v < primitive.normals.size() ? primitive.normals[v] : glm::vec3(0, 0, 1));
        const glm::vec4 tangent = v < primitive.tangents.size() ? primitive.tangents[v] : glm::vec4(1, 0, 0, 1);
        add(base, glm::vec3(tangent));
        base.push_back(tangent.w);
        double total = 0;
        for (const JointSet& set : primitive.joint_sets)
            for (int i = 0; i < 4; ++i)
                total += double(set.weights[v][i]);
        for (const JointSet& set : primitive.joint_sets) {
            const bool first = &set == primitive.joint_sets.data();
            uint32_t joints[2] = {};
            float weights[4];
            for (int i = 0; i < 4; ++i) {
                const bool follows = set.weights[v][i] != 0;
                joints[i / 2] |= uint32_t(follows ? set.joints[v][i] : 0) << (16 * (i % 2));
                // They sum up to 1; without any the first joint is as good as others.
                weights[i] = total > 0 ? static_cast<float>(double(set.weights[v][i]) / total) : first && i == 0;
            }
            influences.insert(influences.end(), {joints[0], joints[1]});
            for (const float weight : weights)
                influences.push_back(std::bit_cast<uint32_t>(weight));
        }
    }

    std::map<const Primitive*, AtRest> known_;
};

uint32_t vec4s(size_t floats) { return static_cast<uint32_t>((floats + 3) / 4); }

std::vector<glm::vec4> state_of(const Deformation& shape) {
    std::vector<glm::vec4> out;
    out.reserve(3 * (shape.joints.size() + shape.previous_joints.size()) + vec4s(shape.weights.size()) +
                vec4s(shape.previous_weights.size()));
    for (const auto* joints : {&shape.joints, &shape.previous_joints})
        for (const glm::mat4& joint : *joints) {
            const glm::mat4 rows = glm::transpose(joint);
            out.insert(out.end(), {rows[0], rows[1], rows[2]});
        }
    for (const auto* weights : {&shape.weights, &shape.previous_weights}) {
        const size_t first = out.size();
        out.resize(first + vec4s(weights->size()), glm::vec4(0));
        for (size_t w = 0; w < weights->size(); ++w)
            out[first + w / 4][static_cast<int>(w % 4)] = (*weights)[w];
    }
    return out;
}

void check_size(const gpu::Context& context, const char* name, uint64_t bytes) {
    const uint64_t limit = context.limits().maxStorageBufferRange;
    if (bytes > limit)
        throw Error(
            fmt::format("{}: {} of skins and morph targets need a buffer of {} bytes, and the device's limit is {}",
                        context.name(), name, bytes, limit));
}

template <class T>
gpu::Buffer upload(const gpu::Context& context, const char* name, const std::vector<T>& values) {
    check_size(context, name, values.size() * sizeof(T));
    return gpu::make_device_buffer(context, name, std::as_bytes(std::span(values)), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

} // namespace

DeviceDeformation::DeviceDeformation(const gpu::Context& context, const World& world, const Geometry& geometry) {
    check_size(context, "positions", geometry.positions.size());
    check_size(context, "vertex attributes", geometry.attributes.size());
    Meshes meshes;
    std::vector<glm::vec4> state;
    std::vector<glm::uvec2> groups;
    for (uint32_t d = 0; d < world.deformed.size(); ++d) {
        Place& place = places_.emplace_back();
        if (!deforms_on_device(world, d) || geometry.deformed[d].empty())
            continue;
        const Deformation& shape = world.deformations[d];
        place = {state.size(), shape.mesh, shape.joints.size(), shape.weights.size(), job_list_.size()};
        const std::vector<glm::vec4> own = state_of(shape);
        const std::vector<Primitive>& primitives = world.scene->meshes[*shape.mesh].primitives;
        for (size_t p = 0; p < primitives.size(); ++p) {
            const Primitive& primitive = primitives[p];
            const auto count = static_cast<uint32_t>(primitive.positions.size());
            if (count == 0 || primitive.indices.empty())
                continue;
            const AtRest& rest = meshes.find(primitive);
            const bool skinned = !shape.joints.empty();
            const uint32_t flags = (primitive.tangents.empty() ? 0 : DEFORM_TANGENTS) |
                                   (primitive.flat_normals ? DEFORM_FLAT : 0) | (shape.turned ? DEFORM_TURNED : 0) |
                                   (geometry.previous_positions.handle() ? DEFORM_PREVIOUS : 0);
            const auto targets = static_cast<uint32_t>(std::min(primitive.morph_targets.size(), shape.weights.size()));
            for (uint32_t v = 0; v < count; v += DEFORM_GROUP)
                groups.emplace_back(job_list_.size(), v);
            job_list_.push_back(
                {.vertices = {geometry.deformed[d][p].first, count, rest.vertices, flags},
                 .data = {rest.influences, skinned ? primitive.joint_sets.size() : 0, rest.targets, targets},
                 .state = {state.size(), shape.joints.size(), count, vec4s(shape.weights.size())}});
        }
        place.jobs = job_list_.size() - place.first_job;
        state.insert(state.end(), own.begin(), own.end());
    }
    groups_ = static_cast<uint32_t>(groups.size());
    jobs_ = upload(context, "primitives to deform", job_list_);
    group_list_ = upload(context, "groups to deform", groups);
    base_ = upload(context, "vertices at rest", meshes.base);
    influences_ = upload(context, "vertex influences", meshes.influences);
    targets_ = upload(context, "morph targets", meshes.targets);
    state_ = upload(context, "joints and weights", state);
}

bool DeviceDeformation::fits(const World& world, uint32_t deformed) const {
    const Place& place = places_[deformed];
    if (!place.mesh)
        return !deforms_on_device(world, deformed);
    const Deformation& shape = world.deformations[deformed];
    return shape.mesh == place.mesh && shape.joints.size() == place.joints && shape.weights.size() == place.weights &&
           shape.previous_joints.size() == place.joints && shape.previous_weights.size() == place.weights;
}

void DeviceDeformation::update(const World& world, uint32_t deformed, gpu::BufferUpdates& updates) {
    const Deformation& shape = world.deformations[deformed];
    const Place& place = places_[deformed];
    const std::vector<glm::vec4> state = state_of(shape);
    updates.write(state_, place.first * sizeof(glm::vec4), std::as_bytes(std::span(state)));
    const std::span jobs = std::span(job_list_).subspan(place.first_job, place.jobs);
    if (!jobs.empty() && ((jobs[0].vertices.w & DEFORM_TURNED) != 0) != shape.turned) {
        for (shared::DeformJob& job : jobs)
            job.vertices.w ^= DEFORM_TURNED;
        updates.write(jobs_, place.first_job * sizeof(shared::DeformJob), std::as_bytes(jobs));
    }
    ++version_;
}

} // namespace prelight::resident
