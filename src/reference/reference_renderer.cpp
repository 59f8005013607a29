#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <platform/clocks.hpp>
#include <prelight/error.hpp>
#include <prelight/light_distribution.hpp>
#include <prelight/views.hpp>
#include <reference/reference_renderer.hpp>
#include <reference/reference_views.hpp>
#include <reference/trace.hpp>
#include <scene/world_to_share.hpp>
#include <setting_values/allows.hpp>
#include <setting_values/needs.hpp>

namespace prelight {
namespace {

using Settings = std::map<std::string, std::string>;
constexpr const char* radius_key = "ambient-occlusion-radius";

/// Every setting with the value in force.
Settings checked_settings(const RendererInfo& info, const RenderOptions& options) {
    Settings settings;
    for (const SettingInfo& setting : info.settings)
        settings[setting.key] = setting.default_value;
    for (const auto& [key, value] : options.settings) {
        const auto setting = std::find_if(info.settings.begin(), info.settings.end(),
                                          [&name = key](const SettingInfo& s) { return s.key == name; });
        if (setting == info.settings.end()) {
            std::vector<std::string> keys;
            for (const SettingInfo& known : info.settings)
                keys.push_back(known.key);
            throw UsageError(fmt::format("reference: unknown setting {} (there are: {})", key, fmt::join(keys, ", ")));
        }
        if (!allows(*setting, value))
            throw UsageError(
                fmt::format("reference: {}={}: not one of {}", key, value, fmt::join(setting->values, ", ")));
        settings[key] = value;
    }
    return settings;
}

double radius_of(const Settings& settings) { return std::strtod(settings.at(radius_key).c_str(), nullptr); }

ReferenceSamples samples_of(const Settings& settings, uint32_t count) {
    using Light = ReferenceSamples::Light;
    static const std::map<std::string, Light> lights{
        {"samples", Light::sample}, {"pixel", Light::pixel}, {"edges", Light::edges}, {"fragment", Light::fragment}};
    const auto rate = [&](const char* key) {
        return settings.at(key) == "fragment" ? ReferenceSamples::Rate::fragment : ReferenceSamples::Rate::sample;
    };
    return {.count = count,
            .light = lights.at(settings.at("msaa-light")),
            .material = rate("msaa-material"),
            .geometry = rate("msaa-geometry"),
            .shadows_per_pixel = settings.at("msaa-shadows") == "pixel",
            .layers = rate("msaa-layers")};
}

ReferenceForm form_of(const Settings& settings, Shading shading, uint32_t samples) {
    using Fresnel = ReferenceForm::Fresnel;
    static const std::map<std::string, Fresnel> forms{
        {"weighted", Fresnel::weighted}, {"nv", Fresnel::nv}, {"mono", Fresnel::mono}, {"full", Fresnel::full}};
    using Shadows = ReferenceForm::TransparentShadows;
    static const std::map<std::string, Shadows> shadows{
        {"opaque", Shadows::opaque}, {"filtered", Shadows::filtered}, {"none", Shadows::none}};
    using Specular = ReferenceForm::Specular;
    static const std::map<std::string, Specular> ways{{"stored", Specular::stored},
                                                      {"luv", Specular::luv},
                                                      {"fifth-channel", Specular::fifth_channel},
                                                      {"luminance", Specular::luminance},
                                                      {"bent", Specular::bent}};
    return {
        .shading = shading,
        .fresnel = forms.at(settings.at("model")),
        .mono_specular = settings.at("specular-light") == "mono",
        .grey_reflectance = settings.at("reflectance") == "grey",
        .gate_by_step = settings.at("specular-gate") == "step",
        .reflection_vector = settings.at("specular-vector") == "reflection",
        .ambient_as_light = settings.at("ambient") == "light",
        .shadows = settings.at("shadows") == "on",
        .specular_antialiasing = settings.at("specular-antialiasing") == "on" && settings.at("specular") == "stored",
        .occlusion_radius = settings.at("ambient-occlusion") == "on" ? radius_of(settings) : 0,
        .bilinear_level0 = settings.at("texture-filter") == "bilinear",
        .specular = ways.at(settings.at("specular")),
        .transparency = settings.at("transparency") == "opaque" ? ReferenceForm::Transparency::opaque
                                                                : ReferenceForm::Transparency::layers,
        .half_samples = settings.at("transparency") == "half-samples",
        .transparent_shadows = shadows.at(settings.at("transparent-shadows")),
        .inferred_scale = reference_form(shading, {{"inferred-scale", settings.at("inferred-scale")}}).inferred_scale,
        .samples = samples_of(settings, samples)};
}

class ReferenceRenderer final : public Renderer {
public:
    explicit ReferenceRenderer(const RenderOptions& options) : options_(options) {
        const RendererInfo info = reference_info();
        check_sample_count(options.msaa);
        stats_.settings = checked_settings(info, options);
        stats_.shading = options.shading.value_or(Shading::ggx);
        choose_fresnel(options);
        for (const auto& [key, value] : options.settings)
            refuse_without_effect(info, key, value, options.views);
        if (stats_.settings.at("transparency") == "half-samples")
            check_half_samples(options);
        check_sample_views(options);
        form_ = form_of(stats_.settings, stats_.shading, options.msaa);
        if (!options.preset.empty())
            throw UsageError(fmt::format("reference: unknown preset {} (it has none)", options.preset));
        if (options.count_pairs)
            throw UsageError("--count-pairs: the reference evaluates no light volumes to count");
        check_size(options.width, options.height);
        for (const std::string& view : options.views)
            take_view(info, view);
        if (std::find(options.views.begin(), options.views.end(), "ambient-occlusion") != options.views.end())
            buffers_.visibility_radius = radius_of(stats_.settings);
        buffers_.curve = options.tonemap;
        stats_.device = "CPU";
        stats_.driver = "Embree 3";
    }

    void set_world(const World& world) override {
        check_lights(*world.scene, world.lights);
        given_ = world_ = &world;
        stats_.lights = world.lights.size();
        stats_.triangles = world.triangles;
        stats_.draws = 0;
        for (const Instance& instance : world.instances)
            stats_.draws += world.mesh_of(instance).primitives.size();
    }

    void share_world(const Renderer& other) override { set_world(world_to_share(other)); }
    const World* world() const override { return given_; }

    void update_world(const WorldChanges& changes) override {
        if (!world_)
            throw Error("renderer: set_world() comes before update_world()");
        if (world_ == given_ || changes.lights)
            return set_world(*given_);
        const std::vector<PlacedLight> lights = relit_.lights;
        set_world(*given_);
        set_lights(lights);
    }

    void set_lights(std::span<const PlacedLight> lights) override {
        if (!world_)
            throw Error("renderer: set_world() comes before set_lights()");
        check_lights(*world_->scene, lights);
        relit_ = *world_;
        relit_.lights.assign(lights.begin(), lights.end());
        world_ = &relit_;
        stats_.lights = lights.size();
    }

    void resize(uint32_t width, uint32_t height) override {
        check_size(width, height);
        options_.width = width;
        options_.height = height;
        drawn_ = false;
    }

    void render(const PlacedCamera& camera, uint32_t frames) override {
        if (!world_)
            throw Error("reference: no world was given");
        std::vector<double> wall, cpu;
        for (uint32_t frame = 0; frame < std::max(frames, 1u); ++frame) {
            const double wall_start = wall_ms(), cpu_start = process_ms();
            picture_ =
                reference::trace(*world_, camera, options_.width, options_.height, options_.exposure, form_, &buffers_);
            cpu.push_back(process_ms() - cpu_start);
            wall.push_back(wall_ms() - wall_start);
        }
        drawn_ = true;
        stats_.frames = static_cast<uint32_t>(wall.size());
        stats_.wall_ms = spread(wall);
        stats_.cpu_ms = spread(cpu);
    }

    Image read(std::string_view view) override {
        if (!drawn_)
            throw Error("reference: nothing has been rendered");
        if (view == "linear")
            return picture_.linear;
        if (view == "final")
            return picture_.display(options_.tonemap);
        if (std::find(options_.views.begin(), options_.views.end(), view) == options_.views.end())
            throw UsageError(fmt::format("reference: view {} was not asked for", view));
        return reference::draw_view(view, picture_, buffers_, std::exp2(options_.exposure));
    }

    Texels texels(std::string_view view) override {
        const auto picture = std::make_shared<const Image>(read(view));
        return {.width = picture->width,
                .height = picture->height,
                .format = Texels::Format::rgb32f,
                .bytes = std::as_bytes(std::span(picture->pixels)),
                .memory = picture};
    }

    uint64_t max_lights() const override { return uint64_t(1) << 24; }
    Stats stats() const override { return stats_; }

private:
    static void check_size(uint32_t width, uint32_t height) {
        if (width == 0 || height == 0)
            throw Error(fmt::format("reference: a picture of {}x{} pixels", width, height));
    }

    void take_view(const RendererInfo& info, const std::string& view) {
        if (!has_view(info, view))
            throw UsageError(fmt::format("reference: unknown view {} (there are: {})", view, names_of_views(info)));
        if (const auto layer = layer_of_view(view))
            buffers_.layers[*layer];
        if (const auto one = sample_of_view(view); one && one->buffer != "final")
            buffers_.samples[one->sample];
    }

    /// Light of another resolution than the picture's knows no Fresnel light by light.
    void choose_fresnel(const RenderOptions& options) {
        std::string& model = stats_.settings.at("model");
        if (stats_.settings.at("inferred-scale") == "none" || model != "full")
            return;
        if (options.settings.contains("model"))
            throw UsageError(
                "--set model=full: has Fresnel light by light, which the sums of inferred-scale do not know "
                "(model=weighted does)");
        model = "weighted";
    }

    void refuse_without_effect(const RendererInfo& info, const std::string& key, const std::string& value,
                               const std::vector<std::string>& views) const {
        const auto setting = std::find_if(info.settings.begin(), info.settings.end(),
                                          [&](const SettingInfo& s) { return s.key == key; });
        const auto why = why_without_effect(key, stats_.settings, stats_.shading, options_.msaa, views);
        if (why && value != setting->default_value)
            throw UsageError(fmt::format("--set {}={}: {}", key, value, *why));
    }

    RenderOptions options_;
    ReferenceForm form_;
    bool drawn_ = false;           ///< picture_ is of this size
    const World* given_ = nullptr; ///< the caller's
    const World* world_ = nullptr; ///< the same, or relit_
    World relit_;                  ///< with the lights of set_lights()
    ReferencePicture picture_;
    reference::ReferenceBuffers buffers_;
    Stats stats_;
};

} // namespace

RendererInfo reference_info() {
    return {
        .name = "reference",
        .description = "rays cast with Embree, lighting in double precision: what the others are "
                       "checked against",
        .settings =
            {
                {"model",
                 {"weighted", "nv", "mono", "full"},
                 "full",
                 "[ggx] Fresnel: weighted mean, at N·V, at N·V with monochrome specular, per "
                 "light"},
                {"specular-gate",
                 {"factor", "step"},
                 "factor",
                 "[phong] specular light times N·L, or only where N·L > 0"},
                {"specular-vector", {"half", "reflection"}, "half", "[phong] (N·H)^n or (R·V)^n"},
                {"specular-light",
                 {"colour", "mono"},
                 "colour",
                 "[phong] specular light in colour or as its luminance"},
                {"specular",
                 {"stored", "luv", "fifth-channel", "luminance", "bent"},
                 "stored",
                 "[phong] a material's own exponent: per light, or on a sum of the lights"},
                {"reflectance", {"colour", "grey"}, "colour", "what lights meet: F0, or its luminance"},
                {"ambient",
                 {"material", "light"},
                 "material",
                 "ambient as a term of the material, or as a light in the diffuse sum"},
                {"shadows", {"off", "on"}, "off", "a shadow ray for every light that casts a shadow"},
                {"transparency",
                 {"layers", "half-samples", "opaque"},
                 "layers",
                 "materials that are blended: each layer of a pixel in its order, the nearest in half of the samples "
                 "(--msaa 4), or drawn opaque"},
                {"transparent-shadows",
                 {"filtered", "opaque", "none"},
                 "filtered",
                 "shadows of blended materials: less deep by alpha, as of opaque ones, or none"},
                {"specular-antialiasing",
                 {"off", "on"},
                 "on",
                 "lights see a rougher surface where normals differ under a pixel; not with a specular way other than "
                 "stored"},
                {"ambient-occlusion", {"off", "on"}, "off", "rays find what occludes ambient light"},
                {radius_key, {"0.01 … 100"}, "1", "metres within which surfaces occlude each other"},
                {"texture-filter",
                 {"bilinear", "sampler"},
                 "bilinear",
                 "always bilinear on level 0, or as samplers say, with mip maps (alpha masks stay on level 0)"},
                {"inferred-scale",
                 {"none", "1", "3/4", "5/8", "1/2"},
                 "none",
                 "lights at this share of the picture's width and height, as the renderer inferred has them; with "
                 "model=weighted where no other is asked for"},
                {"msaa-light",
                 {"samples", "edges", "pixel", "fragment"},
                 "samples",
                 "light at each sample, once for those of a pixel that share a surface, once a pixel, or at its centre "
                 "once a triangle"},
                {"msaa-material",
                 {"sample", "fragment"},
                 "sample",
                 "materials at each sample, or at a pixel's centre once a triangle"},
                {"msaa-geometry", {"sample", "fragment"}, "sample", "normals and roughness that lights see: likewise"},
                {"msaa-shadows",
                 {"sample", "pixel"},
                 "sample",
                 "shadows wherever lights are evaluated, or once for the whole pixel"},
                {"msaa-layers",
                 {"sample", "fragment"},
                 "sample",
                 "blended materials and their light at each sample, or at a pixel's centre once a triangle"},
            },
        .views = {"final", "linear", "depth", "normal", "albedo", "diffuse-light", "specular-light", "light-count",
                  "ambient-occlusion", "layers"},
        .presets = {},
        .needs_device = false,
    };
}

std::unique_ptr<Renderer> make_reference_renderer(const RenderOptions& options) {
    return std::make_unique<ReferenceRenderer>(options);
}

} // namespace prelight
