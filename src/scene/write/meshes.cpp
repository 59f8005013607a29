#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <scene/write/parts.hpp>

namespace prelight::write {
namespace {

/// How many texture-coordinate sets the material reads: 0, 1 or 2. glTF wants set 0 below set 1.
size_t sets_read(const Material& material) {
    size_t sets = 0;
    for (const TextureRef* ref : {&material.base_colour_texture, &material.metallic_roughness_texture,
                                  &material.normal_texture, &material.occlusion_texture, &material.emissive_texture})
        if (*ref)
            sets = std::max<size_t>(sets, ref->texcoord + 1);
    return sets;
}

class MeshWriter {
public:
    MeshWriter(const Scene& scene, Document& document) : scene_(scene), document_(document) {}

    std::optional<uint32_t> write(size_t index) {
        const Mesh& mesh = scene_.meshes[index];
        object_ = label("mesh", index, mesh.name);
        Json entry = Json::object();
        set_name(entry, mesh.name);
        for (const Primitive& primitive : mesh.primitives)
            if (!primitive.indices.empty())
                entry["primitives"].push_back(write(primitive));
        if (!entry.contains("primitives"))
            return {};
        if (!mesh.weights.empty())
            entry["weights"] = reals(mesh.weights);
        return document_.add("meshes", std::move(entry));
    }

private:
    Json write(const Primitive& primitive) {
        if (primitive.material >= scene_.materials.size())
            document_.fail(object_, "uses a material that is not there");
        if (!primitive.facing.empty())
            document_.fail(object_, "has triangles that face the viewer, which only emitters have in a file");
        Json entry;
        Json& attributes = entry["attributes"];
        attributes["POSITION"] = positions(primitive);
        // What deforms with normals of its triangles gets new ones in each pose: left out, the reader
        // makes the same again, and tangents with them.
        const bool made = primitive.flat_normals && (!primitive.joint_sets.empty() || !primitive.morph_targets.empty());
        if (!primitive.normals.empty() && !made)
            attributes["NORMAL"] = vectors(primitive, primitive.normals, "normals");
        if (!primitive.tangents.empty() && !made)
            attributes["TANGENT"] = vectors(primitive, primitive.tangents, "tangents");
        size_t sets = sets_read(scene_.materials[primitive.material]);
        for (size_t set = 0; set < primitive.texcoords.size(); ++set)
            if (!primitive.texcoords[set].empty())
                sets = std::max(sets, set + 1);
        for (size_t set = 0; set < sets; ++set) {
            const bool absent = primitive.texcoords[set].empty();
            const std::vector<glm::vec2> zeros(absent ? primitive.positions.size() : 0);
            attributes[fmt::format("TEXCOORD_{}", set)] =
                vectors(primitive, absent ? zeros : primitive.texcoords[set], "texture coordinates");
        }
        if (!primitive.colours.empty())
            attributes["COLOR_0"] = vectors(primitive, primitive.colours, "colours");
        for (size_t set = 0; set < primitive.joint_sets.size(); ++set)
            add_joints(attributes, primitive, set);
        for (const MorphTarget& target : primitive.morph_targets)
            entry["targets"].push_back(target_of(primitive, target));
        entry["indices"] = indices(primitive);
        entry["material"] = primitive.material;
        return entry;
    }

    template <int N>
    uint32_t vectors(const Primitive& primitive, const std::vector<glm::vec<N, float>>& values, const char* what) {
        if (values.size() != primitive.positions.size())
            document_.fail(object_,
                           fmt::format("has {} positions but {} {}", primitive.positions.size(), values.size(), what));
        for (const auto& value : values)
            for (int i = 0; i < N; ++i)
                if (!std::isfinite(value[i]))
                    document_.fail(object_, fmt::format("its {} are not all finite", what));
        return document_.add_vectors(values, ViewKind::vertices);
    }

    void add_joints(Json& attributes, const Primitive& primitive, size_t index) {
        const JointSet& set = primitive.joint_sets[index];
        if (set.joints.size() != primitive.positions.size())
            document_.fail(
                object_, fmt::format("has {} positions but {} joints", primitive.positions.size(), set.joints.size()));
        const auto bytes = std::as_bytes(std::span(set.joints));
        attributes[fmt::format("JOINTS_{}", index)] =
            document_.add_accessor(document_.add_view(bytes, ViewKind::vertices), 5123, "VEC4", set.joints.size());
        attributes[fmt::format("WEIGHTS_{}", index)] = vectors(primitive, set.weights, "joint weights");
    }

    /// A target that moves nothing still needs one attribute: zeros.
    Json target_of(const Primitive& primitive, const MorphTarget& target) {
        Json entry;
        const bool nothing = target.positions.empty() && target.normals.empty() && target.tangents.empty();
        if (!target.positions.empty() || nothing) {
            const std::vector<glm::vec3> zeros(nothing ? primitive.positions.size() : 0);
            entry["POSITION"] = bounded(primitive, nothing ? zeros : target.positions, "morph targets");
        }
        if (!target.normals.empty())
            entry["NORMAL"] = vectors(primitive, target.normals, "morph targets' normals");
        if (!target.tangents.empty())
            entry["TANGENT"] = vectors(primitive, target.tangents, "morph targets' tangents");
        return entry;
    }

    uint32_t positions(const Primitive& primitive) { return bounded(primitive, primitive.positions, "positions"); }

    /// Vectors with the bounds that glTF wants of positions.
    uint32_t bounded(const Primitive& primitive, const std::vector<glm::vec3>& values, const char* what) {
        const uint32_t accessor = vectors(primitive, values, what);
        glm::vec3 low = values.at(0), high = low;
        for (const glm::vec3& p : values) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
        document_.root["accessors"][accessor]["min"] = numbers(low);
        document_.root["accessors"][accessor]["max"] = numbers(high);
        return accessor;
    }

    uint32_t indices(const Primitive& primitive) {
        const size_t count = primitive.indices.size();
        if (count % 3 != 0 ||
            *std::max_element(primitive.indices.begin(), primitive.indices.end()) >= primitive.positions.size())
            document_.fail(object_, "its indices are not triangles of its vertices");
        if (primitive.positions.size() > 65535) { // 65,535 itself would be primitive restart
            const auto bytes = std::as_bytes(std::span(primitive.indices));
            return document_.add_accessor(document_.add_view(bytes, ViewKind::indices), 5125, "SCALAR", count);
        }
        std::vector<uint16_t> small;
        small.reserve(count);
        for (const uint32_t index : primitive.indices)
            small.push_back(static_cast<uint16_t>(index));
        const auto bytes = std::as_bytes(std::span(small));
        return document_.add_accessor(document_.add_view(bytes, ViewKind::indices), 5123, "SCALAR", count);
    }

    const Scene& scene_;
    Document& document_;
    std::string object_; ///< for messages
};

} // namespace

std::vector<std::optional<uint32_t>> add_meshes(const Scene& scene, Document& document) {
    MeshWriter writer(scene, document);
    std::vector<std::optional<uint32_t>> written;
    for (size_t i = 0; i < scene.meshes.size(); ++i)
        written.push_back(writer.write(i));
    return written;
}

} // namespace prelight::write
