#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <scene/animate.hpp>
#include <scene/gltf/primitives.hpp>
#include <scene/gltf/triangles.hpp>
#include <scene/gltf/vectors.hpp>
#include <scene/tangents.hpp>

namespace prelight::gltf {
namespace {

/// What making tangents takes for one corner of a triangle while it runs.
constexpr uint64_t tangent_work_bytes = 256;
/// An index as read; and a triangle's corner as read, while it is compacted, and kept.
constexpr uint64_t index_bytes = 4, corner_index_bytes = 16;

/// Elements::index() of what is direct().
template <class Index>
auto direct_index(const Elements& source) {
    return [from = source.base, stride = source.stride](uint32_t i) -> uint32_t {
        Index index;
        std::memcpy(&index, from + i * stride, sizeof index);
        return index;
    };
}

class PrimitiveReader {
public:
    PrimitiveReader(Document& document, Buffers& buffers, Accessors& accessors, Scene& scene, const Item& item)
        : document_(document), buffers_(buffers), accessors_(accessors), scene_(scene), item_(item),
          attributes_(document, accessors, item) {}

    /// Nothing when the primitive makes no triangles.
    std::optional<Primitive> read() {
        const uint64_t mode = item_.integer_or("mode", uint64_t(Mode::triangles));
        if (mode > uint64_t(Mode::fan)) {
            item_.warn("mode {} is not known; the primitive is left out", mode);
            return {};
        }
        if (mode < uint64_t(Mode::triangles))
            return skip("points and lines are not drawn");
        if (!attributes_.has("POSITION"))
            return skip("primitives without POSITION are not drawn");
        read_topology(Mode(mode));
        if (primitive_.indices.empty())
            return skip("primitives without a whole triangle are not drawn");
        read_material();
        read_attributes();
        if (primitive_.indices.empty())
            return skip("primitives without a whole triangle are not drawn");
        complete();
        return std::move(primitive_);
    }

private:
    std::optional<Primitive> skip(const char* reason) {
        document_.warn(reason, item_.label());
        return {};
    }

    /// Indices as a triangle list over `used_`, the vertices that are really needed: many
    /// primitives may share one large buffer.
    void read_topology(Mode mode) {
        if (const auto extension = item_.extension("KHR_draco_mesh_compression")) {
            const DracoMesh& draco = attributes_.set_draco(buffers_, *extension);
            document_.charge(item_.label(), draco.corners(), corner_index_bytes);
            primitive_.indices = draco.indices();
        } else {
            attributes_.count_vertices();
            std::vector<uint32_t> indices = read_indices();
            const uint64_t corners = indices.size() * (mode == Mode::triangles ? 1 : 3);
            document_.charge(item_.label(), corners, corner_index_bytes);
            primitive_.indices = triangle_list(std::move(indices), mode);
        }
        attributes_.set_used(compact(primitive_.indices));
    }

    std::vector<uint32_t> read_indices() {
        const uint32_t vertices = attributes_.vertices();
        std::vector<uint32_t> indices;
        const auto accessor = item_.index("indices", document_.count(Table::accessors));
        if (!accessor) {
            document_.charge(item_.label(), vertices, index_bytes);
            indices.resize(vertices);
            for (uint32_t i = 0; i < vertices; ++i)
                indices[i] = i;
            return indices;
        }
        const Elements& source = accessors_.get(*accessor);
        const std::string mismatch = kind_mismatch(source, "SCALAR of unsigned integers, which indices are");
        if (source.width != 1 || (source.component != Component::u8 && source.component != Component::u16 &&
                                  source.component != Component::u32))
            item_.fail(mismatch);
        if (source.normalized)
            item_.warn("{}; they are read as they are", mismatch);
        const uint32_t restart = uint32_t((uint64_t(1) << (8 * size_of(source.component))) - 1);
        document_.charge(item_.label(), source.count, index_bytes);
        indices.resize(source.count);
        const auto read = [&](const auto& index_at) {
            for (uint32_t i = 0; i < source.count; ++i) {
                const uint32_t index = index_at(i);
                if (index >= vertices || index == restart)
                    item_.fail(fmt::format("index {} (number {}) is beyond its {} vertices", index, i, vertices));
                indices[i] = index;
            }
        };
        if (source.direct() && source.component == Component::u32)
            read(direct_index<uint32_t>(source));
        else if (source.direct() && source.component == Component::u16)
            read(direct_index<uint16_t>(source));
        else
            read([&](uint32_t i) { return source.index(i); });
        return indices;
    }

    void read_material() {
        const auto index = item_.index("material", document_.count(Table::materials));
        if (!index && scene_.materials.size() == document_.count(Table::materials))
            scene_.materials.emplace_back().name = "default";
        primitive_.material = index.value_or(uint32_t(document_.count(Table::materials)));
    }

    void read_attributes() {
        const size_t used = attributes_.used().size();
        document_.charge(item_.label(), used, vertex_bytes());
        primitive_.positions.resize(used);
        const std::vector<uint32_t> nowhere =
            gather("POSITION", Semantic::position, glm::vec4(0), "the triangles at it are left out",
                   [&](uint32_t i, glm::vec4 v) { primitive_.positions[i] = glm::vec3(v); });
        if (!nowhere.empty())
            drop_triangles_at(primitive_, nowhere);
        gather("NORMAL", Semantic::normal, glm::vec4(0), "", primitive_.normals, // zero ones are made anew
               [](glm::vec4 v) { return glm::vec3(v); });
        if (needs_tangents())
            gather("TANGENT", Semantic::tangent, glm::vec4(0), "", primitive_.tangents, [](glm::vec4 v) { return v; });
        for (size_t set = 0; set < primitive_.texcoords.size(); ++set)
            gather(fmt::format("TEXCOORD_{}", set), Semantic::texcoord, glm::vec4(0), "(0, 0) is used",
                   primitive_.texcoords[set], [](glm::vec4 v) { return glm::vec2(v); });
        read_joints(document_, item_, attributes_, primitive_);
        moving_bytes_ += primitive_.joint_sets.size() * joint_set_bytes;
        read_targets();
        read_colours();
    }

    /// Calls `store(place, value)` for each vertex; nothing when there is no such attribute.
    template <class Store>
    std::vector<uint32_t> gather(const std::string& name, Semantic semantic, glm::vec4 instead, std::string_view repair,
                                 Store store) {
        const Attributes::Values values = attributes_.find(name, semantic);
        return values ? attributes_.gather(item_, name, values, instead, repair, store) : std::vector<uint32_t>();
    }

    /// The same into a list, which stays empty when there is no such attribute.
    template <class T, class Convert>
    void gather(const std::string& name, Semantic semantic, glm::vec4 instead, std::string_view repair,
                std::vector<T>& out, Convert convert) {
        const Attributes::Values values = attributes_.find(name, semantic);
        if (!values)
            return;
        out.resize(attributes_.used().size());
        attributes_.gather(item_, name, values, instead, repair, [&](uint32_t i, glm::vec4 v) { out[i] = convert(v); });
    }

    void read_colours() {
        const Attributes::Values values = attributes_.find("COLOR_0", Semantic::colour);
        if (!values)
            return;
        const bool alpha = values.elements->width == 4;
        primitive_.colours.resize(attributes_.used().size());
        attributes_.gather(item_, "COLOR_0", values, glm::vec4(1), "white is used", [&](uint32_t i, glm::vec4 v) {
            v.w = alpha ? v.w : 1;
            primitive_.colours[i] = glm::clamp(v, 0.f, 1.f);
        });
    }

    void read_targets() {
        const std::vector<Item> targets = item_.items("targets", "target");
        document_.charge(item_.label(), targets.size(), sizeof(MorphTarget));
        for (const Item& target : targets) {
            MorphTarget& out = primitive_.morph_targets.emplace_back();
            read_deltas(target, "POSITION", Semantic::position_delta, out.positions);
            if (!primitive_.normals.empty()) // else both are made anew
                read_deltas(target, "NORMAL", Semantic::normal_delta, out.normals);
            if (!primitive_.tangents.empty())
                read_deltas(target, "TANGENT", Semantic::tangent_delta, out.tangents);
            if (target.has("TEXCOORD_0") || target.has("TEXCOORD_1") || target.has("COLOR_0"))
                document_.warn("morph targets move no texture coordinates and colours", target.label());
        }
    }

    void read_deltas(const Item& target, const char* name, Semantic semantic, std::vector<glm::vec3>& out) {
        const Attributes::Values values = attributes_.find_delta(target, name, semantic);
        if (!values)
            return;
        document_.charge(target.label(), attributes_.used().size(), sizeof(glm::vec3));
        moving_bytes_ += sizeof(glm::vec3);
        out.resize(attributes_.used().size());
        attributes_.gather(target, name, values, glm::vec4(0), "it does not move",
                           [&](uint32_t i, glm::vec4 v) { out[i] = glm::vec3(v); });
    }

    /// A vertex with the attributes that the primitive has or will get.
    uint64_t vertex_bytes() const {
        return 12 + 12 + 2 * 8 + (needs_tangents() ? 16 : 0) + (attributes_.has("COLOR_0") ? 16 : 0) + moving_bytes_;
    }

    const Material& material() const { return scene_.materials[primitive_.material]; }
    bool needs_tangents() const {
        const Material& m = material(); // a shader of its own may read any texture as a normal map
        return m.normal_texture ||
               (m.shader && attributes_.has(m.normal_texture.texcoord == 1 ? "TEXCOORD_1" : "TEXCOORD_0"));
    }

    /// Makes what the file left out, so that every primitive that is drawn has it.
    void complete() {
        fill_missing_texcoords();
        if (primitive_.normals.empty()) {
            document_.charge(item_.label(), primitive_.indices.size(), vertex_bytes());
            make_flat_normals(primitive_);
        } else {
            unit_normals(item_, primitive_);
        }
        if (!needs_tangents())
            return;
        if (!unit_tangents()) {
            document_.charge(item_.label(), primitive_.indices.size(), vertex_bytes());
            const Loan work(document_.budget(), Budget::Pool::geometry, primitive_.indices.size() * tangent_work_bytes);
            generate_tangents(primitive_, material().normal_texture);
        }
    }

    void fill_missing_texcoords() {
        const Material& m = material();
        for (const TextureRef* ref : {&m.base_colour_texture, &m.metallic_roughness_texture, &m.normal_texture,
                                      &m.occlusion_texture, &m.emissive_texture}) {
            if (!*ref || !primitive_.texcoords[ref->texcoord].empty())
                continue;
            document_.warn("a texture without its texture coordinates is drawn at (0, 0)", item_.label());
            primitive_.texcoords[ref->texcoord].assign(primitive_.positions.size(), glm::vec2(0));
        }
    }

    /// False when there are none, or one that gives no direction.
    bool unit_tangents() {
        if (primitive_.tangents.empty())
            return false;
        for (glm::vec4& tangent : primitive_.tangents) {
            const glm::dvec3 t{glm::vec3(tangent)};
            const double length = glm::length(t);
            if (!(length > 1e-20)) {
                document_.warn("tangents without a direction are replaced by MikkTSpace's", item_.label());
                primitive_.tangents.clear();
                for (MorphTarget& target : primitive_.morph_targets)
                    target.tangents.clear();
                return false;
            }
            tangent = glm::vec4(glm::vec3(t / length), tangent.w < 0 ? -1.f : 1.f);
        }
        return true;
    }

    Document& document_;
    Buffers& buffers_;
    Accessors& accessors_;
    Scene& scene_;
    const Item& item_;
    Attributes attributes_;
    uint64_t moving_bytes_ = 0; ///< of a vertex: joints, weights and morph targets
    Primitive primitive_;
};

} // namespace

std::vector<float> read_weights(Document& document, const Item& item, const Mesh& mesh) {
    std::vector<float> weights = item.reals("weights");
    document.charge(item.label(), weights.size(), sizeof(float));
    if (!weights.empty() && !mesh.primitives.empty() && weights.size() != morph_targets(mesh))
        item.warn("weights has {} values for {} morph targets; missing ones are 0", weights.size(),
                  morph_targets(mesh));
    if (!mesh.primitives.empty() && !weights.empty())
        weights.resize(morph_targets(mesh));
    return weights;
}

void read_meshes(Document& document, Buffers& buffers, Accessors& accessors, Scene& scene) {
    document.charge("meshes", document.count(Table::meshes), sizeof(Mesh));
    scene.meshes.resize(document.count(Table::meshes));
    for (size_t i = 0; i < scene.meshes.size(); ++i) {
        const Item item = document.item(Table::meshes, i);
        scene.meshes[i].name = item.text("name");
        for (const Item& primitive : item.items("primitives", "primitive")) {
            document.charge(primitive.label(), 1, sizeof(Primitive));
            try {
                auto read = PrimitiveReader(document, buffers, accessors, scene, primitive).read();
                if (!read)
                    continue;
                scene.meshes[i].primitives.push_back(std::move(*read));
                const size_t targets = scene.meshes[i].primitives.back().morph_targets.size();
                if (targets != morph_targets(scene.meshes[i]))
                    primitive.fail(fmt::format("has {} morph targets, but the mesh's first has {}", targets,
                                               morph_targets(scene.meshes[i])));
            } catch (const Budget::Exceeded& error) {
                primitive.fail(error.what());
            }
        }
        scene.meshes[i].weights = read_weights(document, item, scene.meshes[i]);
    }
}

} // namespace prelight::gltf
