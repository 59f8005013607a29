#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <prelight/material_shader.hpp>
#include <scene/write/parts.hpp>

namespace prelight::write {
namespace {

int wrap_code(Wrap wrap) { return wrap == Wrap::repeat ? 10497 : wrap == Wrap::mirrored_repeat ? 33648 : 33071; }

int filter_code(Filter filter) { return filter == Filter::nearest ? 9728 : 9729; }

/// 9984 … 9987: the low bit filters within a level, the next one between levels.
int min_filter_code(const Sampler& sampler) {
    if (sampler.mip == MipFilter::none)
        return filter_code(sampler.min);
    return 9984 + (sampler.min == Filter::linear ? 1 : 0) + (sampler.mip == MipFilter::linear ? 2 : 0);
}

/// rotation and scale with uv_linear = R(rotation) · diag(scale), where R turns counter-clockwise
/// in an image whose v points down: columns (cos, −sin) and (sin, cos).
struct Turn {
    double rotation = 0;
    glm::dvec2 scale{1};
};

/// Absent: the matrix has shear.
std::optional<Turn> turn_and_scale(const glm::mat2& linear) {
    const glm::dmat2 m(linear);
    if (m[0].y == 0 && m[1].x == 0) // exact, negative scales included
        return Turn{.rotation = 0, .scale = {m[0].x, m[1].y}};
    const double sx = glm::length(m[0]), sy = glm::length(m[1]);
    if (std::abs(glm::dot(m[0], m[1])) > 1e-5 * sx * sy)
        return {};
    const double angle = sx > 0 ? std::atan2(-m[0].y, m[0].x) : std::atan2(m[1].x, m[1].y);
    return Turn{.rotation = angle, .scale = {sx, glm::determinant(m) < 0 ? -sy : sy}};
}

class MaterialWriter {
public:
    MaterialWriter(const Scene& scene, Document& document) : scene_(scene), document_(document) {}

    void write(size_t index) {
        const Material& material = scene_.materials[index];
        object_ = label("material", index, material.name);
        Json entry = Json::object();
        set_name(entry, material.name);
        entry["pbrMetallicRoughness"] = metallic_roughness(material);
        set_texture(entry, "normalTexture", material.normal_texture);
        if (material.normal_texture && material.normal_scale != 1)
            entry["normalTexture"]["scale"] = checked(material.normal_scale);
        set_texture(entry, "occlusionTexture", material.occlusion_texture);
        if (material.occlusion_texture && material.occlusion_strength != 1)
            entry["occlusionTexture"]["strength"] = unit(material.occlusion_strength);
        set_emissive(entry, material);
        if (material.alpha_mode == AlphaMode::mask) {
            entry["alphaMode"] = "MASK";
            entry["alphaCutoff"] = checked(std::max(material.alpha_cutoff, 0.0f));
        } else if (material.alpha_mode == AlphaMode::blend) {
            entry["alphaMode"] = "BLEND";
        }
        if (material.double_sided)
            entry["doubleSided"] = true;
        if (material.unlit) {
            document_.use("KHR_materials_unlit");
            entry["extensions"]["KHR_materials_unlit"] = Json::object();
        }
        set_own(entry, material);
        document_.add("materials", std::move(entry));
    }

private:
    Json checked(float value) const {
        if (!std::isfinite(value))
            document_.fail(object_, "holds a number that is not finite");
        return number(value);
    }
    Json unit(float value) const {
        checked(value);
        return number(std::clamp(value, 0.0f, 1.0f));
    }

    Json metallic_roughness(const Material& material) {
        Json entry = Json::object();
        if (material.base_colour != glm::vec4(1))
            for (int channel = 0; channel < 4; ++channel)
                entry["baseColorFactor"].push_back(unit(material.base_colour[channel]));
        set_texture(entry, "baseColorTexture", material.base_colour_texture);
        if (material.metallic != 1)
            entry["metallicFactor"] = unit(material.metallic);
        if (material.roughness != 1)
            entry["roughnessFactor"] = unit(material.roughness);
        set_texture(entry, "metallicRoughnessTexture", material.metallic_roughness_texture);
        return entry;
    }

    void set_emissive(Json& entry, const Material& material) {
        set_texture(entry, "emissiveTexture", material.emissive_texture);
        const glm::vec3 emissive = glm::max(material.emissive, glm::vec3(0));
        if (emissive == glm::vec3(0))
            return;
        const float largest = std::max({emissive.r, emissive.g, emissive.b});
        checked(emissive.r + emissive.g + emissive.b);
        float strength = 1; // a power of two: dividing by it rounds nothing
        while (largest > strength)
            strength *= 2;
        entry["emissiveFactor"] = numbers(emissive / strength);
        if (strength != 1) {
            document_.use("KHR_materials_emissive_strength");
            entry["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", number(strength)}};
        }
    }

    void set_own(Json& entry, const Material& material) {
        Json own = Json::object();
        if (material.shader && material.shader->file.empty())
            own["material"] = material.shader->name;
        if (!material.receives_decals)
            own["receivesDecals"] = false;
        if (material.softness > 0)
            own["softness"] = checked(material.softness);
        for (const auto& [name, value] : material.parameters) {
            const MaterialParameter* declared = material.shader ? material.shader->find_parameter(name) : nullptr;
            const uint32_t components = declared ? declared->components : 4;
            for (uint32_t c = 0; c < components; ++c)
                own["parameters"][name].push_back(checked(value[static_cast<int>(c)]));
        }
        for (const auto& [name, ref] : material.textures)
            if (ref)
                set_texture(own["textures"], name.c_str(), ref);
        if (!own.empty())
            entry["extras"]["prelight"] = std::move(own);
    }

    void set_texture(Json& owner, const char* key, const TextureRef& ref) {
        if (!ref)
            return;
        if (ref.image >= scene_.images.size())
            document_.fail(object_, "uses an image that is not there");
        Json& info = owner[key];
        info = {{"index", texture(ref)}};
        if (ref.texcoord != 0)
            info["texCoord"] = ref.texcoord;
        if (ref.uv_linear != glm::mat2(1) || ref.uv_offset != glm::vec2(0))
            info["extensions"]["KHR_texture_transform"] = transform(ref);
    }

    Json transform(const TextureRef& ref) {
        const auto turn = turn_and_scale(ref.uv_linear);
        if (!turn)
            document_.fail(object_, "a texture transform with shear has no form in glTF");
        document_.use("KHR_texture_transform");
        Json entry = Json::object();
        if (ref.uv_offset != glm::vec2(0))
            entry["offset"] = {checked(ref.uv_offset.x), checked(ref.uv_offset.y)};
        if (turn->rotation != 0)
            entry["rotation"] = turn->rotation;
        if (turn->scale != glm::dvec2(1))
            entry["scale"] = {turn->scale.x, turn->scale.y};
        return entry;
    }

    template <typename T>
    static uint32_t find_or_append(std::vector<T>& list, const T& value) {
        const auto found = std::find(list.begin(), list.end(), value);
        if (found == list.end())
            return list.push_back(value), static_cast<uint32_t>(list.size() - 1);
        return static_cast<uint32_t>(found - list.begin());
    }

    uint32_t texture(const TextureRef& ref) {
        const size_t samplers = samplers_.size();
        const uint32_t sampler = find_or_append(samplers_, ref.sampler);
        if (samplers_.size() > samplers)
            document_.add("samplers", {{"magFilter", filter_code(ref.sampler.mag)},
                                       {"minFilter", min_filter_code(ref.sampler)},
                                       {"wrapS", wrap_code(ref.sampler.wrap_s)},
                                       {"wrapT", wrap_code(ref.sampler.wrap_t)}});
        const size_t textures = textures_.size();
        const uint32_t index = find_or_append(textures_, {ref.image, sampler});
        if (textures_.size() > textures)
            document_.add("textures", {{"sampler", sampler}, {"source", ref.image}});
        return index;
    }

    const Scene& scene_;
    Document& document_;
    std::string object_; ///< for messages
    std::vector<Sampler> samplers_;
    std::vector<std::pair<uint32_t, uint32_t>> textures_; ///< image, sampler
};

} // namespace

void add_materials(const Scene& scene, Document& document) {
    MaterialWriter writer(scene, document);
    for (size_t i = 0; i < scene.materials.size(); ++i)
        writer.write(i);
}

} // namespace prelight::write
