#include "light_model_settings.hpp"
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <renderers/light_sums.hpp>

namespace prelight {
namespace {

using passes::FresnelModel;
using passes::LightBufferFormat;
using passes::LightModel;
using passes::SpecularWay;

constexpr Choice<LightBufferFormat> buffer_words[] = {{"rgba16f", LightBufferFormat::rgba16f},
                                                      {"r11g11b10f", LightBufferFormat::r11g11b10f},
                                                      {"rgb10a2", LightBufferFormat::rgb10a2},
                                                      {"rgba8", LightBufferFormat::rgba8},
                                                      {"packed-rgba16f", LightBufferFormat::packed_rgba16f},
                                                      {"packed-rgba8", LightBufferFormat::packed_rgba8}};
constexpr ChoiceSetting<LightBufferFormat> buffer_setting{
    "light-buffer", buffer_words, "rgba16f",
    "diffuse and specular pair, or specular packed into alpha (equation 8.5.2)"};

constexpr Choice<SpecularWay> specular_words[] = {{"stored", SpecularWay::stored},
                                                  {"luv", SpecularWay::luv},
                                                  {"fifth-channel", SpecularWay::fifth_channel},
                                                  {"luminance", SpecularWay::luminance},
                                                  {"bent", SpecularWay::bent}};
constexpr ChoiceSetting<SpecularWay> specular_setting{"specular", specular_words, "stored",
                                                      "phong: where a material's own shininess comes in"};

constexpr Choice<FresnelModel> buffer_model_words[] = {{"weighted", FresnelModel::weighted},
                                                       {"nv", FresnelModel::nv},
                                                       {"mono", FresnelModel::mono},
                                                       {"full", FresnelModel::full}};
/// Of a light buffer.
constexpr ChoiceSetting<FresnelModel> buffer_model_setting{
    "model", buffer_model_words, "auto", "Fresnel: mean over the lights, at N·V, or with monochrome specular (packed)",
    true};

constexpr Choice<FresnelModel> model_words[] = {{"full", FresnelModel::full}, {"nv", FresnelModel::nv}};
/// Where each light meets its surface's material.
constexpr ChoiceSetting<FresnelModel> model_setting_of_materials{"model", model_words, "full",
                                                                 "Fresnel: of each light at V·H, or at N·V"};

/// Ways 2 to 5 raise one channel of equation 8.5.2 to the material's exponent.
void check_specular_way(Settings& settings, LightModel& model) {
    const std::string asked = "--set specular=" + settings.get("specular");
    if (model.specular == SpecularWay::stored)
        return;
    if (model.shading != Shading::phong) {
        if (settings.given("specular"))
            throw UsageError(asked + ": is a way of --shading phong");
        settings.fall_back("specular", "stored", "is a way of --shading phong");
        model.specular = SpecularWay::stored;
        return;
    }
    if (model.step_gate && model.specular != SpecularWay::bent)
        throw UsageError(asked + ": divides by the sum of N·L, which specular-gate=step does not have");
    if (model.packed())
        return;
    const char* packed = model.fixed_point() ? "packed-rgba8" : "packed-rgba16f";
    if (settings.given("light-buffer"))
        throw UsageError(fmt::format("{}: needs equation 8.5.2 in one target (light-buffer={})", asked, packed));
    settings.resolve("light-buffer", packed,
                     "specular=" + settings.get("specular") + " needs equation 8.5.2 in one target");
    model.buffer = settings.value(buffer_setting);
}

/// What raises a sum of lights takes the exponent as the material says it: the first pass's roughness is not asked.
void resolve_specular_antialiasing(Settings& settings, const LightModel& model) {
    if (model.specular == SpecularWay::stored || settings.is("specular-antialiasing", "off"))
        return;
    if (settings.given("specular-antialiasing"))
        throw UsageError(fmt::format("--set specular-antialiasing=on: specular={} does not take the stored roughness",
                                     settings.get("specular")));
    settings.resolve("specular-antialiasing", "off",
                     "specular=" + settings.get("specular") + " does not take the stored roughness");
}

void choose_fresnel(Settings& settings, LightModel& model) {
    if (settings.given("model") && settings.shading() == Shading::phong)
        settings.refuse_without_effect(); // before what a form of Fresnel would need
    if (settings.is("model", "auto"))
        settings.resolve("model",
                         model.packed()      ? "mono"
                         : model.has_alpha() ? "weighted"
                                             : "nv",
                         "the most that light-buffer=" + settings.get("light-buffer") + " holds");
    const std::string& word = settings.get("model");
    model.fresnel = settings.value(buffer_model_setting);
    if (model.fresnel == FresnelModel::full)
        throw UsageError("--set model=full: a light buffer has no Fresnel of each light; renderer "
                         "reference has");
    if (model.packed() != (model.fresnel == FresnelModel::mono))
        throw UsageError("--set model=" + word + ": " +
                         (model.packed() ? "a packed light buffer holds model=mono only"
                                         : "needs a packed light buffer (light-buffer=packed-rgba16f)"));
    if (model.fresnel == FresnelModel::weighted && !model.has_alpha())
        throw UsageError(fmt::format("--set model=weighted: light-buffer={} has no alpha for it (model=nv)",
                                     settings.get("light-buffer")));
}

/// Lights that are drawn one by one are blended; in a loop over all of them, or over a list, they are
/// written once. Chromaticity does not add up, so that LUV is always written once.
void choose_writes(Settings& settings, const LightModel& model) {
    const std::string& culling = settings.get("light-culling");
    const bool lists = culling == "tiles" || culling == "clusters";
    const bool luv = model.specular == SpecularWay::luv;
    const bool once = luv || lists || settings.is("light-writes", "once");
    if (settings.is("light-writes", "blended") && once)
        throw UsageError(fmt::format("--set light-writes=blended: {} is written once",
                                     luv ? "specular=luv" : "light-culling=" + culling));
    if (once && !lists && culling != "fullscreen") {
        const char* asked = luv ? "specular=luv" : "light-writes=once";
        if (settings.given("light-culling"))
            throw UsageError(fmt::format("--set {}: light-culling={} blends light by light "
                                         "(light-culling=fullscreen, tiles and clusters do not have to)",
                                         asked, culling));
        settings.resolve("light-culling", "tiles", std::string(asked) + " writes each pixel once");
    }
    settings.resolve("light-writes", once ? "once" : "blended",
                     luv ? "chromaticity does not add up"
                         : "as light-culling=" + settings.get("light-culling") + " does");
}

} // namespace

std::vector<SettingInfo> light_model_settings() {
    return {buffer_setting.info(),
            {"light-scale",
             {"auto", "0.01 … 1000"},
             "auto",
             "rgb10a2, rgba8, packed-rgba8: the largest light that is stored; auto: from the light of each frame"},
            {"light-writes",
             {"auto", "blended", "once"},
             "auto",
             "lights blended one by one, or summed first and written once (fullscreen, tiles, clusters)"},
            light_sums_setting(),
            specular_setting.info(),
            buffer_model_setting.info(),
            specular_gate_setting(),
            specular_vector_setting(),
            {"ambient", {"material", "light"}, "material", "a material term, or a full-screen light"}};
}

SettingInfo model_setting() { return model_setting_of_materials.info(); }

SettingInfo specular_gate_setting() {
    return {"specular-gate", {"factor", "step"}, "factor", "phong: N·L times, or only where N·L > 0"};
}

SettingInfo specular_vector_setting() {
    return {"specular-vector", {"half", "reflection"}, "half", "phong: N·H or R·V"};
}

passes::LightModel material_light_model(const Settings& settings) {
    return {.shading = settings.shading(),
            .fresnel = settings.value(model_setting_of_materials),
            .step_gate = settings.is("specular-gate", "step"),
            .reflection_vector = settings.is("specular-vector", "reflection")};
}

passes::LightModel blended_light_model(const Settings& settings) {
    return {.shading = settings.shading(),
            .fresnel = settings.value(buffer_model_setting), // it has the words of the other table too
            .step_gate = settings.is("specular-gate", "step"),
            .reflection_vector = settings.is("specular-vector", "reflection"),
            .specular_antialiasing = settings.is("specular-antialiasing", "on")};
}

passes::LightModel light_model(Settings& settings, Shading shading) {
    LightModel model{.shading = shading,
                     .buffer = settings.value(buffer_setting),
                     .specular = settings.value(specular_setting),
                     .step_gate = settings.is("specular-gate", "step"),
                     .reflection_vector = settings.is("specular-vector", "reflection"),
                     .ambient_as_light = settings.is("ambient", "light")};
    check_specular_way(settings, model);
    resolve_specular_antialiasing(settings, model);
    choose_fresnel(settings, model);
    choose_writes(settings, model);
    if (model.fixed_point() && settings.is("light-sums", "float32"))
        throw UsageError("--set light-sums=float32: light-buffer=" + settings.get("light-buffer") + " adds up codes");
    return model;
}

} // namespace prelight
