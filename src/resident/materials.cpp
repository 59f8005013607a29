#include "scene.hpp"
#include <array>
#include <fmt/format.h>
#include <gpu/check.hpp>
#include <prelight/error.hpp>
#include <shared/bindings.h>
#include <shared/frame.h>

namespace prelight::resident {
namespace {

struct Slot {
    TextureRef Material::* ref;
    uint32_t binding;
    uint32_t feature;
    bool srgb;
};
constexpr std::array slots{
    Slot{&Material::base_colour_texture, MATERIAL_BASE_COLOUR, FEATURE_BASE_COLOUR_TEXTURE, true},
    Slot{&Material::metallic_roughness_texture, MATERIAL_METALLIC_ROUGHNESS,
         FEATURE_METALLIC_ROUGHNESS_TEXTURE, false},
    Slot{&Material::normal_texture, MATERIAL_NORMAL, FEATURE_NORMAL_TEXTURE, false},
    Slot{&Material::occlusion_texture, MATERIAL_OCCLUSION, FEATURE_OCCLUSION_TEXTURE, false},
    Slot{&Material::emissive_texture, MATERIAL_EMISSIVE, FEATURE_EMISSIVE_TEXTURE, true}};

shared::MaterialConstants constants_of(const Material& m, double exposure) {
    shared::MaterialConstants c{};
    c.base_colour = m.base_colour;
    c.emissive = glm::vec4(m.emissive * static_cast<float>(exposure), m.alpha_cutoff);
    c.factors = glm::vec4(m.metallic, m.roughness, m.normal_scale, m.occlusion_strength);
    for (const Slot& slot : slots) {
        const TextureRef& ref = m.*slot.ref;
        c.uv_linear[slot.binding - 1] = glm::vec4(ref.uv_linear[0], ref.uv_linear[1]);
        c.uv_offset[slot.binding - 1] = glm::vec4(ref.uv_offset, float(ref.texcoord), 0);
    }
    return c;
}

/// Finds or makes what materials share.
class Cache {
public:
    Cache(const gpu::Context& context, const Scene& scene, gpu::TextureFilter filter, Materials& out)
        : context_(context), scene_(scene), filter_(filter), out_(out), uploader_(context) {}

    /// Waits until all textures are there.
    void finish() { uploader_.finish(); }

    gpu::Binding binding(const Slot& slot, const TextureRef& ref) {
        const gpu::Texture& texture = find_texture(ref ? ref.image : no_image, slot.srgb);
        return gpu::Binding::texture(slot.binding, texture.view(), find_sampler(ref.sampler));
    }

private:
    const gpu::Texture& find_texture(uint32_t image, bool srgb) {
        const auto key = std::pair(image, srgb);
        const auto found = out_.textures.find(key);
        if (found != out_.textures.end())
            return found->second;
        static const TextureImage white{"white", 1, 1, {255, 255, 255, 255}};
        const TextureImage& source = image == no_image ? white : scene_.images[image];
        const auto encoding = srgb                                      ? gpu::TextureEncoding::srgb8
                              : filter_ == gpu::TextureFilter::bilinear ? gpu::TextureEncoding::half
                                                                        : gpu::TextureEncoding::linear8;
        return out_.textures.emplace(key, gpu::Texture(context_, out_.pool, uploader_, source, encoding)).first->second;
    }
    VkSampler find_sampler(const Sampler& sampler) {
        for (size_t i = 0; i < known_.size(); ++i)
            if (known_[i] == sampler)
                return out_.samplers[i];
        known_.push_back(sampler);
        return out_.samplers.emplace_back(gpu::make_sampler(context_, sampler, filter_));
    }
    const gpu::Context& context_;
    const Scene& scene_;
    gpu::TextureFilter filter_;
    Materials& out_;
    std::vector<Sampler> known_;
    gpu::Uploader uploader_;
};

} // namespace

uint32_t features_of(const Material& material) {
    uint32_t features = 0;
    for (const Slot& slot : slots)
        if (material.*slot.ref)
            features |= slot.feature;
    if (material.alpha_mode == AlphaMode::mask)
        features |= FEATURE_ALPHA_MASK;
    if (material.unlit)
        features |= FEATURE_UNLIT;
    return features;
}

Materials upload_materials(const gpu::Context& context, const Scene& scene, gpu::TextureFilter filter,
                           double exposure) {
    if (scene.materials.empty())
        throw Error(fmt::format("{}: a scene has at least one material", scene.name));
    Materials out(context);
    const uint64_t alignment = context.limits().minUniformBufferOffsetAlignment;
    const uint64_t stride = (sizeof(shared::MaterialConstants) + alignment - 1) / alignment * alignment;
    std::vector<std::byte> constants(stride * std::max<size_t>(scene.materials.size(), 1));
    for (size_t m = 0; m < scene.materials.size(); ++m) {
        const shared::MaterialConstants c = constants_of(scene.materials[m], exposure);
        std::copy_n(reinterpret_cast<const std::byte*>(&c), sizeof c, constants.data() + m * stride);
    }
    out.constants =
        gpu::make_device_buffer(context, "material constants", constants, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);

    Cache cache(context, scene, filter, out);
    std::vector<std::vector<gpu::Binding>> sets;
    for (size_t m = 0; m < scene.materials.size(); ++m) {
        auto& set = sets.emplace_back();
        set.push_back(gpu::Binding::uniform(MATERIAL_CONSTANTS, out.constants.handle(), m * stride,
                                            sizeof(shared::MaterialConstants)));
        for (const Slot& slot : slots)
            set.push_back(cache.binding(slot, scene.materials[m].*slot.ref));
    }
    cache.finish();
    out.layout = gpu::make_set_layout(context, "material", sets.at(0));
    out.sets = gpu::DescriptorSets(context, "material", out.layout, sets);
    return out;
}

} // namespace prelight::resident
