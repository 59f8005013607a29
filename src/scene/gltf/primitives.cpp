#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <scene/animate.hpp>
#include <scene/gltf/draco_mesh.hpp>
#include <scene/gltf/primitives.hpp>
#include <scene/gltf/triangles.hpp>
#include <scene/tangents.hpp>

namespace prelight::gltf {
namespace {

/// What making tangents takes for one corner of a triangle while it runs.
constexpr uint64_t tangent_work_bytes = 256;
/// An index as read; and a triangle's corner as read, while it is compacted, and kept.
constexpr uint64_t index_bytes = 4, corner_index_bytes = 16;
/// Four joints and weights.
constexpr uint64_t joint_set_bytes = 4 * 2 + 4 * 4;

bool is_finite(const glm::vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

class PrimitiveReader {
public:
    PrimitiveReader(Document& document, Buffers& buffers, Accessors& accessors, Scene& scene,
                    const Item& item)
        : document_(document), buffers_(buffers), accessors_(accessors), scene_(scene), item_(item),
          attributes_(item.object("attributes")) {}

    /// Nothing when the primitive makes no triangles.
    std::optional<Primitive> read() {
        const uint64_t mode = item_.integer_or("mode", uint64_t(Mode::triangles));
        if (mode > uint64_t(Mode::fan))
            item_.fail(fmt::format("mode {} is not known", mode));
        if (mode < uint64_t(Mode::triangles))
            return skip("points and lines are not drawn");
        if (!attributes_ || !attributes_->has("POSITION"))
            return skip("primitives without POSITION are not drawn");
        read_topology(Mode(mode));
        if (primitive_.indices.empty())
            return skip("primitives without a whole triangle are not drawn");
        read_material();
        read_attributes();
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
            draco_.emplace(document_, buffers_, *extension);
            vertices_ = draco_->points();
            document_.charge(item_.label(), draco_->corners(), corner_index_bytes);
            primitive_.indices = draco_->indices();
        } else {
            vertices_ = elements("POSITION", 3)->count;
            std::vector<uint32_t> indices = read_indices();
            const uint64_t corners = indices.size() * (mode == Mode::triangles ? 1 : 3);
            document_.charge(item_.label(), corners, corner_index_bytes);
            primitive_.indices = triangle_list(std::move(indices), mode);
        }
        used_ = compact(primitive_.indices);
    }

    std::vector<uint32_t> read_indices() {
        std::vector<uint32_t> indices;
        const auto accessor = item_.index("indices", document_.count(Table::accessors));
        if (!accessor) {
            document_.charge(item_.label(), vertices_, index_bytes);
            indices.resize(vertices_);
            for (uint32_t i = 0; i < vertices_; ++i)
                indices[i] = i;
            return indices;
        }
        const Elements& source = accessors_.get(*accessor);
        if (source.width != 1 || source.normalized ||
            (source.component != Component::u8 && source.component != Component::u16 &&
             source.component != Component::u32))
            gltf::fail(document_.file(), source.label, "is not fit for indices");
        const uint32_t restart = uint32_t((uint64_t(1) << (8 * size_of(source.component))) - 1);
        document_.charge(item_.label(), source.count, index_bytes);
        indices.reserve(source.count);
        for (uint32_t i = 0; i < source.count; ++i) {
            const uint32_t index = source.index(i);
            if (index >= vertices_ || index == restart)
                item_.fail(fmt::format("index {} (number {}) is beyond its {} vertices", index, i,
                                       vertices_));
            indices.push_back(index);
        }
        return indices;
    }

    void read_material() {
        const auto index = item_.index("material", document_.count(Table::materials));
        if (!index && scene_.materials.size() == document_.count(Table::materials))
            scene_.materials.emplace_back().name = "default";
        primitive_.material = index.value_or(uint32_t(document_.count(Table::materials)));
    }

    /// Checked values of an attribute, `least` … 4 components wide; nothing when it is absent.
    const Elements* elements(const char* name, uint32_t least) {
        const auto accessor = attributes_->index(name, document_.count(Table::accessors));
        if (!accessor)
            return nullptr;
        const Elements* found = nullptr;
        if (draco_) {
            const Item item = document_.item(Table::accessors, *accessor);
            document_.charge(item_.label(), vertices_, sizeof(uint32_t));
            draco_elements_ = draco_->attribute(name, item.flag("normalized"));
            if (draco_elements_)
                found = &*draco_elements_;
        }
        if (!found)
            found = &accessors_.get(*accessor);
        if (found->width < least || found->component == Component::u32)
            item_.fail(fmt::format("{}: its type is not fit for that", name));
        if (vertices_ != 0 && found->count != vertices_)
            item_.fail(
                fmt::format("{}: has {} values for {} vertices", name, found->count, vertices_));
        return found;
    }

    /// Calls `store(place, value)` for each used vertex.
    template <class Store>
    void gather(const char* name, const Elements& source, Store store) {
        for (uint32_t place = 0; place < used_.size(); ++place) {
            const glm::vec4 value = source.vec(used_[place]);
            if (!is_finite(value))
                item_.fail(fmt::format("{}: vertex {} is not finite", name, used_[place]));
            store(place, value);
        }
    }

    void read_attributes() {
        document_.charge(item_.label(), used_.size(), vertex_bytes());
        const Elements* source = elements("POSITION", 3);
        primitive_.positions.resize(used_.size());
        gather("POSITION", *source,
               [&](uint32_t i, glm::vec4 v) { primitive_.positions[i] = glm::vec3(v); });
        if ((source = elements("NORMAL", 3))) {
            primitive_.normals.resize(used_.size());
            gather("NORMAL", *source,
                   [&](uint32_t i, glm::vec4 v) { primitive_.normals[i] = glm::vec3(v); });
        }
        if ((source = needs_tangents() ? elements("TANGENT", 4) : nullptr)) {
            primitive_.tangents.resize(used_.size());
            gather("TANGENT", *source,
                   [&](uint32_t i, glm::vec4 v) { primitive_.tangents[i] = v; });
        }
        read_texcoords("TEXCOORD_0", 0);
        read_texcoords("TEXCOORD_1", 1);
        for (uint32_t set = 0; read_joints(set);)
            ++set;
        read_targets();
        if ((source = elements("COLOR_0", 3))) {
            primitive_.colours.resize(used_.size());
            const bool alpha = source->width == 4;
            gather("COLOR_0", *source, [&](uint32_t i, glm::vec4 v) {
                v.w = alpha ? v.w : 1;
                primitive_.colours[i] = glm::clamp(v, 0.f, 1.f);
            });
        }
    }

    void read_texcoords(const char* name, size_t set) {
        const Elements* source = elements(name, 2);
        if (!source)
            return;
        primitive_.texcoords[set].resize(used_.size());
        gather(name, *source,
               [&](uint32_t i, glm::vec4 v) { primitive_.texcoords[set][i] = glm::vec2(v); });
    }

    /// JOINTS_n and WEIGHTS_n; false when there are none.
    bool read_joints(uint32_t set) {
        const std::string joints_name = fmt::format("JOINTS_{}", set);
        const std::string weights_name = fmt::format("WEIGHTS_{}", set);
        const Elements* source = elements(joints_name.c_str(), 4);
        if (attributes_->has(joints_name) != attributes_->has(weights_name))
            item_.fail(fmt::format("{} and {} must stand together", joints_name, weights_name));
        if (!source)
            return false;
        if (source->normalized ||
            (source->component != Component::u8 && source->component != Component::u16))
            item_.fail(fmt::format("{}: its type is not fit for that", joints_name));
        document_.charge(item_.label(), used_.size(), joint_set_bytes);
        moving_bytes_ += joint_set_bytes;
        JointSet& out = primitive_.joint_sets.emplace_back();
        out.joints.resize(used_.size());
        gather(joints_name.c_str(), *source,
               [&](uint32_t i, glm::vec4 v) { out.joints[i] = glm::vec<4, uint16_t>(v); });
        source = elements(weights_name.c_str(), 4);
        if (source->component != Component::f32 &&
            (!source->normalized ||
             (source->component != Component::u8 && source->component != Component::u16)))
            item_.fail(fmt::format("{}: its type is not fit for that", weights_name));
        out.weights.resize(used_.size());
        gather(weights_name.c_str(), *source, [&](uint32_t i, glm::vec4 v) {
            for (int k = 0; k < 4; ++k) {
                if (v[k] < 0)
                    item_.fail(fmt::format("{}: vertex {} has a negative weight", weights_name, used_[i]));
                if (v[k] == 0) // where nothing follows it, a joint may have any number
                    out.joints[i][k] = 0;
            }
            out.weights[i] = v;
        });
        return true;
    }

    void read_targets() {
        const std::vector<Item> targets = item_.items("targets", "target");
        document_.charge(item_.label(), targets.size(), sizeof(MorphTarget));
        for (const Item& target : targets) {
            MorphTarget& out = primitive_.morph_targets.emplace_back();
            read_deltas(target, "POSITION", out.positions);
            if (!primitive_.normals.empty()) // else both are made anew
                read_deltas(target, "NORMAL", out.normals);
            if (!primitive_.tangents.empty())
                read_deltas(target, "TANGENT", out.tangents);
            if (target.has("TEXCOORD_0") || target.has("TEXCOORD_1") || target.has("COLOR_0"))
                document_.warn("morph targets move no texture coordinates and colours", target.label());
        }
    }

    void read_deltas(const Item& target, const char* name, std::vector<glm::vec3>& out) {
        const auto accessor = target.index(name, document_.count(Table::accessors));
        if (!accessor)
            return;
        const Elements& source = accessors_.get(*accessor);
        if (source.width != 3 || source.component == Component::u32)
            target.fail(fmt::format("{}: its type is not fit for that", name));
        if (source.count != vertices_)
            target.fail(fmt::format("{}: has {} values for {} vertices", name, source.count, vertices_));
        document_.charge(target.label(), used_.size(), sizeof(glm::vec3));
        moving_bytes_ += sizeof(glm::vec3);
        out.resize(used_.size());
        for (uint32_t place = 0; place < used_.size(); ++place) {
            const glm::vec4 value = source.vec(used_[place]);
            if (!is_finite(value))
                target.fail(fmt::format("{}: vertex {} is not finite", name, used_[place]));
            out[place] = glm::vec3(value);
        }
    }

    /// A vertex with the attributes that the primitive has or will get.
    uint64_t vertex_bytes() const {
        return 12 + 12 + 2 * 8 + (needs_tangents() ? 16 : 0) +
               (attributes_->has("COLOR_0") ? 16 : 0) + moving_bytes_;
    }

    const Material& material() const { return scene_.materials[primitive_.material]; }
    bool needs_tangents() const {
        const Material& m = material(); // a shader of its own may read any texture as a normal map
        return m.normal_texture || (m.shader && attributes_->has(m.normal_texture.texcoord == 1 ? "TEXCOORD_1" : "TEXCOORD_0"));
    }

    /// Makes what the file left out, so that every primitive that is drawn has it.
    void complete() {
        fill_missing_texcoords();
        if (primitive_.normals.empty()) {
            document_.charge(item_.label(), primitive_.indices.size(), vertex_bytes());
            make_flat_normals(primitive_);
        } else {
            unit_normals();
        }
        if (!needs_tangents())
            return;
        if (!unit_tangents()) {
            document_.charge(item_.label(), primitive_.indices.size(), vertex_bytes());
            const Loan work(document_.budget(), Budget::Pool::geometry,
                            primitive_.indices.size() * tangent_work_bytes);
            generate_tangents(primitive_, material().normal_texture);
        }
    }

    void fill_missing_texcoords() {
        const Material& m = material();
        for (const TextureRef* ref :
             {&m.base_colour_texture, &m.metallic_roughness_texture, &m.normal_texture,
              &m.occlusion_texture, &m.emissive_texture}) {
            if (!*ref || !primitive_.texcoords[ref->texcoord].empty())
                continue;
            document_.warn("a texture without its texture coordinates is drawn at (0, 0)",
                           item_.label());
            primitive_.texcoords[ref->texcoord].assign(primitive_.positions.size(), glm::vec2(0));
        }
    }

    /// Unit length; where a normal is zero, the sum of the triangles around its vertex.
    void unit_normals() {
        std::vector<glm::vec3>& normals = primitive_.normals;
        std::vector<bool> bad(normals.size());
        bool any_bad = false;
        for (size_t i = 0; i < normals.size(); ++i) {
            const glm::dvec3 n(normals[i]);
            const double length = glm::length(n);
            any_bad |= bad[i] = !(length > 1e-20);
            normals[i] = bad[i] ? glm::vec3(0) : glm::vec3(n / length);
        }
        if (!any_bad)
            return;
        std::vector<glm::dvec3> sums(normals.size());
        for (size_t i = 0; i + 2 < primitive_.indices.size(); i += 3) {
            const uint32_t* corner = &primitive_.indices[i];
            const glm::dvec3 a(primitive_.positions[corner[0]]);
            const glm::dvec3 normal = glm::cross(glm::dvec3(primitive_.positions[corner[1]]) - a,
                                                 glm::dvec3(primitive_.positions[corner[2]]) - a);
            for (int c = 0; c < 3; ++c)
                sums[corner[c]] += normal;
        }
        for (size_t i = 0; i < normals.size(); ++i)
            if (bad[i])
                normals[i] = glm::length(sums[i]) > 0 ? glm::vec3(glm::normalize(sums[i]))
                                                      : glm::vec3(0, 0, 1);
        document_.warn("zero normals are taken from the triangles", item_.label());
    }

    /// False when there are none, or one that gives no direction.
    bool unit_tangents() {
        if (primitive_.tangents.empty())
            return false;
        for (glm::vec4& tangent : primitive_.tangents) {
            const glm::dvec3 t{glm::vec3(tangent)};
            const double length = glm::length(t);
            if (!(length > 1e-20)) {
                document_.warn("tangents without a direction are replaced by MikkTSpace's",
                               item_.label());
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
    std::optional<Item> attributes_;
    std::optional<DracoMesh> draco_;
    std::optional<Elements> draco_elements_;
    uint32_t vertices_ = 0;
    std::vector<uint32_t> used_;
    uint64_t moving_bytes_ = 0; ///< of a vertex: joints, weights and morph targets
    Primitive primitive_;
};

} // namespace

std::vector<float> read_weights(Document& document, const Item& item, const Mesh& mesh) {
    std::vector<float> weights = item.reals("weights");
    document.charge(item.label(), weights.size(), sizeof(float));
    if (!weights.empty() && !mesh.primitives.empty() && weights.size() != morph_targets(mesh))
        item.fail(fmt::format("weights: has {} values for {} morph targets", weights.size(),
                              morph_targets(mesh)));
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
