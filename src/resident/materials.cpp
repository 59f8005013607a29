#include "environment.hpp"
#include "mask_levels.hpp"
#include "mip_levels.hpp"
#include "normal_map_levels.hpp"
#include "reflectance_table.hpp"
#include "scene.hpp"
#include "texture_limit.hpp"
#include <array>
#include <cstring>
#include <fmt/format.h>
#include <gpu/check.hpp>
#include <prelight/error.hpp>
#include <scene/tangents.hpp>
#include <shared/bindings.h>
#include <shared/frame.h>

namespace prelight::resident {
namespace {

struct Slot {
    TextureRef Material::*ref;
    uint32_t binding;
    uint32_t feature;
    TextureUse use;
};
constexpr std::array slots{
    Slot{&Material::base_colour_texture, MATERIAL_BASE_COLOUR, FEATURE_BASE_COLOUR_TEXTURE, TextureUse::colour},
    Slot{&Material::metallic_roughness_texture, MATERIAL_METALLIC_ROUGHNESS, FEATURE_METALLIC_ROUGHNESS_TEXTURE,
         TextureUse::values},
    Slot{&Material::normal_texture, MATERIAL_NORMAL, FEATURE_NORMAL_TEXTURE, TextureUse::normals},
    Slot{&Material::occlusion_texture, MATERIAL_OCCLUSION, FEATURE_OCCLUSION_TEXTURE, TextureUse::values},
    Slot{&Material::emissive_texture, MATERIAL_EMISSIVE, FEATURE_EMISSIVE_TEXTURE, TextureUse::colour}};

/// The material's texture for one that its shader declares; none: an empty reference.
const TextureRef& own_texture(const Material& material, const std::string& name) {
    static const TextureRef none;
    const auto found = material.textures.find(name);
    return found == material.textures.end() ? none : found->second;
}

/// For each material what the alpha of its base-colour texture is compared with: its cut-off over the alpha that the
/// texture is multiplied by, of the vertices their mean. 0: it has no mask, or one that its texture does not decide.
std::vector<float> mask_cutoffs(const Scene& scene) {
    std::vector<double> alpha(scene.materials.size()), vertices(scene.materials.size());
    for (const Mesh& mesh : scene.meshes)
        for (const Primitive& primitive : mesh.primitives)
            if (primitive.material < alpha.size() &&
                scene.materials[primitive.material].alpha_mode == AlphaMode::mask) {
                vertices[primitive.material] += static_cast<double>(primitive.positions.size());
                for (size_t v = 0; v < primitive.positions.size(); ++v)
                    alpha[primitive.material] +=
                        primitive.colours.empty() ? 1.0 : static_cast<double>(primitive.colours[v].a);
            }
    std::vector<float> cutoffs(scene.materials.size(), 0);
    for (size_t m = 0; m < cutoffs.size(); ++m) {
        const Material& material = scene.materials[m];
        if (material.alpha_mode != AlphaMode::mask || !material.base_colour_texture)
            continue;
        const double factor =
            static_cast<double>(material.base_colour.a) * (vertices[m] > 0 ? alpha[m] / vertices[m] : 1.0);
        if (factor > 0 && static_cast<double>(material.alpha_cutoff) <= factor)
            cutoffs[m] = static_cast<float>(static_cast<double>(material.alpha_cutoff) / factor);
    }
    return cutoffs;
}

/// The std140 block of the shader's parameters.
void write_parameters(const Material& material, std::byte* block) {
    for (const MaterialParameter& parameter : material.shader->parameters) {
        const auto given = material.parameters.find(parameter.name);
        const glm::vec4 value = given == material.parameters.end() ? parameter.default_value : given->second;
        std::memcpy(block + parameter.offset, &value, 4 * parameter.components);
    }
}

const TextureImage& stand_in(MaterialTexture::StandIn kind) {
    using StandIn = MaterialTexture::StandIn;
    static const TextureImage white{"white", 1, 1, {255, 255, 255, 255}}, black{"black", 1, 1, {0, 0, 0, 255}},
        flat{"flat", 1, 1, {128, 128, 255, 255}};
    return kind == StandIn::black ? black : kind == StandIn::flat ? flat : white;
}

/// Finds or makes what materials share.
class Cache {
public:
    Cache(const gpu::Context& context, const Scene& scene, gpu::TextureFilter filter, Materials& out)
        : context_(context), scene_(scene), filter_(filter), out_(out), uploader_(context) {}

    /// Of samplers that are asked for from now on.
    void filter(gpu::TextureFilter filter) {
        filter_ = filter;
        known_.clear();
    }

    /// Waits until all textures are there.
    void finish() { uploader_.finish(); }

    /// `cutoff`: what its alpha is compared with; 0: with nothing.
    gpu::Binding binding(uint32_t binding, TextureUse use, const TextureRef& ref,
                         MaterialTexture::StandIn without = MaterialTexture::StandIn::white, float cutoff = 0) {
        const bool masked = cutoff > 0 && ref.sampler.mip != MipFilter::none && filter_ != gpu::TextureFilter::bilinear;
        const gpu::Texture& texture = masked ? find_mask(ref, cutoff) : find_texture(ref.image, use, without);
        return gpu::Binding::texture(binding, texture.view(), find_sampler(ref.sampler));
    }

    /// What the material's shader declares for the slot, or something to fill it.
    gpu::Binding own_binding(const Material& material, uint32_t slot) {
        if (material.shader)
            for (const MaterialTexture& own : material.shader->textures)
                if (own.slot == slot)
                    return binding(MATERIAL_OWN_TEXTURE + slot, own.colour ? TextureUse::colour : TextureUse::values,
                                   own_texture(material, own.name), own.stand_in);
        return binding(MATERIAL_OWN_TEXTURE + slot, TextureUse::values, {});
    }

    void make_environment(double exposure) {
        const EnvironmentLevels levels = prefilter(scene_.environment.get());
        out_.environment.emplace(context_, out_.pool, uploader_, "environment", levels.images);
        out_.sky.emplace(context_, out_.pool, uploader_, "sky", std::vector{levels.sky});
        const Image table = scene_.environment ? make_reflectance_table() : Image(1, 1);
        out_.reflectance.emplace(context_, out_.pool, uploader_, "reflectance of mirrors", std::vector{table});
        out_.table_sampler = gpu::make_sampler(
            context_, {.wrap_s = Wrap::clamp_to_edge, .wrap_t = Wrap::clamp_to_edge, .mip = MipFilter::none}, filter_);
        out_.environment_sampler = make_environment_sampler(context_);
        const shared::EnvironmentConstants constants = environment_constants(levels, exposure);
        out_.environment_light = gpu::make_device_buffer(
            context_, "environment light", std::as_bytes(std::span(&constants, 1)), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    }

private:
    const gpu::Texture& find_texture(uint32_t image, TextureUse use, MaterialTexture::StandIn without) {
        const TextureImage& source = image == no_image ? stand_in(without) : scene_.images[image];
        const auto key = std::pair(&source, use);
        const auto found = out_.textures.find(key);
        if (found != out_.textures.end())
            return found->second;
        const auto encoding = use == TextureUse::colour                 ? gpu::TextureEncoding::srgb8
                              : filter_ == gpu::TextureFilter::bilinear ? gpu::TextureEncoding::half
                                                                        : gpu::TextureEncoding::linear8;
        const auto smaller = scaled_to_limit(source,
                                             use == TextureUse::colour    ? images::Texels::colour
                                             : use == TextureUse::normals ? images::Texels::normals
                                                                          : images::Texels::values,
                                             context_.limits().maxImageDimension2D);
        const TextureImage& texels = smaller ? *smaller : source;
        return out_.textures.emplace(key, make_texture(texels, use, encoding)).first->second;
    }
    gpu::Texture make_texture(const TextureImage& texels, TextureUse use, gpu::TextureEncoding encoding) {
        if (use == TextureUse::normals)
            return with_levels(normal_map_levels(texels), encoding);
        // A software device compiles its blit between levels at every start, which takes longer than the levels here.
        if (context_.is_software())
            return {context_, out_.pool, uploader_, texels, mip_levels(texels, use == TextureUse::colour), encoding};
        return {context_, out_.pool, uploader_, texels, encoding};
    }
    gpu::Texture with_levels(const std::vector<TextureImage>& levels, gpu::TextureEncoding encoding) {
        return {context_, out_.pool, uploader_, levels[0], std::span(levels).subspan(1), encoding};
    }
    /// One for each cut-off and way of filtering.
    const gpu::Texture& find_mask(const TextureRef& ref, float cutoff) {
        const TextureImage& source = scene_.images[ref.image];
        const Sampler& s = ref.sampler;
        const auto number = [](auto value) { return static_cast<uint32_t>(value); };
        const std::tuple key(&source, cutoff,
                             number(s.mag) | number(s.min) << 4 | number(s.wrap_s) << 8 | number(s.wrap_t) << 12);
        const auto found = out_.masks.find(key);
        if (found != out_.masks.end())
            return found->second;
        return out_.masks.emplace(key, with_levels(mask_levels(source, cutoff, s), gpu::TextureEncoding::srgb8))
            .first->second;
    }
    VkSampler find_sampler(const Sampler& sampler) {
        for (size_t i = 0; i < known_.size(); ++i)
            if (known_[i].first == sampler)
                return known_[i].second;
        const gpu::UniqueSampler& made = out_.samplers.emplace_back(gpu::make_sampler(context_, sampler, filter_));
        known_.emplace_back(sampler, made);
        return made;
    }
    const gpu::Context& context_;
    const Scene& scene_;
    gpu::TextureFilter filter_;
    Materials& out_;
    std::vector<std::pair<Sampler, VkSampler>> known_;
    gpu::Uploader uploader_;
};

} // namespace

shared::MaterialConstants material_constants(const Material& m, double exposure) {
    shared::MaterialConstants c{};
    c.base_colour = m.base_colour;
    c.emissive = glm::vec4(m.emissive * static_cast<float>(exposure),
                           m.alpha_mode == AlphaMode::blend ? m.softness : m.alpha_cutoff);
    c.factors = glm::vec4(m.metallic, m.roughness, m.normal_scale, m.occlusion_strength);
    const auto place = [&](uint32_t binding, const TextureRef& ref) {
        c.uv_linear[binding - 1] = glm::vec4(ref.uv_linear[0], ref.uv_linear[1]);
        c.uv_offset[binding - 1] =
            glm::vec4(ref.uv_offset, float(ref.texcoord), share_tangents(ref, m.normal_texture) ? 1 : 0);
    };
    for (const Slot& slot : slots)
        place(slot.binding, m.*slot.ref);
    if (m.shader)
        for (const MaterialTexture& own : m.shader->textures)
            place(MATERIAL_OWN_TEXTURE + own.slot, own_texture(m, own.name));
    return c;
}

std::vector<MaterialKey> material_keys(const Scene& scene) {
    const std::vector<float> cutoffs = mask_cutoffs(scene);
    std::vector<MaterialKey> keys;
    for (size_t m = 0; m < scene.materials.size(); ++m) {
        const Material& material = scene.materials[m];
        MaterialKey& key = keys.emplace_back(MaterialKey{.shader = material.shader.get(),
                                                         .alpha_mode = material.alpha_mode,
                                                         .unlit = material.unlit,
                                                         .double_sided = material.double_sided,
                                                         .receives_decals = material.receives_decals,
                                                         .transmits = transmits(material),
                                                         .soft = material.softness > 0,
                                                         .mask_cutoff = cutoffs[m],
                                                         .textures = {}});
        const auto add = [&](const TextureRef& ref) { key.textures.emplace_back(ref.image, ref.sampler); };
        for (const Slot& slot : slots)
            add(material.*slot.ref);
        if (material.shader)
            for (const MaterialTexture& own : material.shader->textures)
                add(own_texture(material, own.name));
    }
    return keys;
}

void update_material(const Materials& materials, const Scene& scene, uint32_t index, double exposure,
                     gpu::BufferUpdates& updates) {
    const Material& material = scene.materials[index];
    check_material(material, fmt::format("{}: material {} ({})", scene.name, index, material.name));
    const shared::MaterialConstants constants = material_constants(material, exposure);
    updates.write(materials.constants, index * materials.constants_stride, std::as_bytes(std::span(&constants, 1)));
    if (!material.shader)
        return;
    std::vector<std::byte> parameters(materials.parameters_stride);
    write_parameters(material, parameters.data());
    updates.write(materials.parameters, index * materials.parameters_stride, parameters);
}

uint32_t features_of(const Scene& scene, const Material& material) {
    uint32_t features = 0;
    for (const Slot& slot : slots)
        if (material.*slot.ref)
            features |= slot.feature;
    if (material.alpha_mode == AlphaMode::mask)
        features |= FEATURE_ALPHA_MASK;
    if (material.unlit)
        features |= FEATURE_UNLIT;
    if (scene.environment && !material.unlit)
        features |= FEATURE_ENVIRONMENT;
    if (!material.shader)
        return features;
    for (const MaterialTexture& own : material.shader->textures)
        if (own_texture(material, own.name))
            features |= FEATURE_OWN_TEXTURE << own.slot;
    return features;
}

Materials upload_materials(const gpu::Context& context, const Scene& scene, gpu::TextureFilter filter,
                           double exposure) {
    if (scene.materials.empty())
        throw Error(fmt::format("{}: a scene has at least one material", scene.name));
    for (size_t m = 0; m < scene.materials.size(); ++m)
        check_material(scene.materials[m], fmt::format("{}: material {} ({})", scene.name, m, scene.materials[m].name));
    Materials out(context);
    out.shaders = MaterialShaders(scene);
    const uint64_t alignment = context.limits().minUniformBufferOffsetAlignment;
    const auto padded = [&](uint64_t size) { return (size + alignment - 1) / alignment * alignment; };
    uint64_t most_parameters = 16;
    for (const Material& material : scene.materials)
        if (material.shader)
            most_parameters = std::max<uint64_t>(most_parameters, material.shader->parameter_bytes);
    most_parameters = (most_parameters + 15) / 16 * 16;
    const uint64_t stride = padded(sizeof(shared::MaterialConstants)), parameter_stride = padded(most_parameters);
    out.constants_stride = stride;
    out.parameters_stride = parameter_stride;
    out.keys = material_keys(scene);
    std::vector<std::byte> constants(stride * scene.materials.size()),
        parameters(parameter_stride * scene.materials.size());
    for (size_t m = 0; m < scene.materials.size(); ++m) {
        const shared::MaterialConstants c = material_constants(scene.materials[m], exposure);
        std::memcpy(constants.data() + m * stride, &c, sizeof c);
        if (scene.materials[m].shader)
            write_parameters(scene.materials[m], parameters.data() + m * parameter_stride);
    }
    constexpr auto uniform = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
    out.constants = gpu::make_device_buffer(context, "material constants", constants, uniform);
    out.parameters = gpu::make_device_buffer(context, "material parameters", parameters, uniform);

    Cache cache(context, scene, filter, out);
    cache.make_environment(exposure);
    const auto bindings = [&](size_t m) {
        const Material& material = scene.materials[m];
        std::vector<gpu::Binding> set;
        set.push_back(gpu::Binding::uniform(MATERIAL_CONSTANTS, out.constants.handle(), m * stride,
                                            sizeof(shared::MaterialConstants)));
        for (const Slot& slot : slots)
            set.push_back(cache.binding(slot.binding, slot.use, material.*slot.ref, MaterialTexture::StandIn::white,
                                        slot.binding == MATERIAL_BASE_COLOUR ? out.keys[m].mask_cutoff : 0));
        if (out.surface_maps.size() == m)
            out.surface_maps.push_back({set[1], set[2], set[3]});
        for (uint32_t slot = 0; slot < MATERIAL_OWN_TEXTURES; ++slot)
            set.push_back(cache.own_binding(material, slot));
        set.push_back(gpu::Binding::texture(MATERIAL_ENVIRONMENT, out.environment->view(), out.environment_sampler));
        set.push_back(gpu::Binding::texture(MATERIAL_SKY, out.sky->view(), out.environment_sampler));
        set.push_back(gpu::Binding::texture(MATERIAL_REFLECTANCE, out.reflectance->view(), out.table_sampler));
        set.push_back(
            gpu::Binding::uniform(MATERIAL_PARAMETERS, out.parameters.handle(), m * parameter_stride, most_parameters));
        set.push_back(gpu::Binding::uniform(MATERIAL_ENVIRONMENT_LIGHT, out.environment_light.handle()));
        return set;
    };
    const auto sets = [&](const char* name) {
        std::vector<std::vector<gpu::Binding>> all;
        for (size_t m = 0; m < scene.materials.size(); ++m)
            all.push_back(bindings(m));
        if (!out.layout)
            out.layout = gpu::make_set_layout(context, "material", all.at(0));
        return gpu::DescriptorSets(context, name, out.layout, all);
    };
    out.sets = sets("material");
    if (filter == gpu::TextureFilter::anisotropic && context.is_software()) {
        cache.filter(gpu::TextureFilter::trilinear);
        out.isotropic_sets = sets("material, isotropic filters");
    }
    cache.finish();
    return out;
}

} // namespace prelight::resident
