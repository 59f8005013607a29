#include "light_model_settings.hpp"
#include "light_sums.hpp"
#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight {
namespace {

using passes::FresnelModel;
using passes::LightBufferFormat;
using passes::LightModel;
using passes::SpecularWay;

LightBufferFormat buffer_format(const std::string& value) {
    return value == "rgba16f"          ? LightBufferFormat::rgba16f
           : value == "r11g11b10f"     ? LightBufferFormat::r11g11b10f
           : value == "rgb10a2"        ? LightBufferFormat::rgb10a2
           : value == "rgba8"          ? LightBufferFormat::rgba8
           : value == "packed-rgba16f" ? LightBufferFormat::packed_rgba16f
                                       : LightBufferFormat::packed_rgba8;
}

SpecularWay specular_way(const std::string& value) {
    return value == "stored"          ? SpecularWay::stored
           : value == "luv"           ? SpecularWay::luv
           : value == "fifth-channel" ? SpecularWay::fifth_channel
           : value == "luminance"     ? SpecularWay::luminance
                                      : SpecularWay::bent;
}

/// Ways 2 to 5 raise one channel of equation 8.5.2 to the material's exponent.
void check_specular_way(Settings& settings, LightModel& model) {
    const std::string asked = "--set specular=" + settings.get("specular");
    if (model.specular == SpecularWay::stored)
        return;
    if (model.shading != Shading::phong) {
        if (settings.given("specular"))
            throw UsageError(asked + ": is a way of --shading phong");
        settings.note("specular=" + settings.get("specular") + " is for phong, stored is taken");
        settings.resolve("specular", "stored");
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
    settings.resolve("light-buffer", packed);
    model.buffer = buffer_format(packed);
}

/// What raises a sum of lights takes the exponent as the material says it: the first pass's roughness is not asked.
void resolve_specular_antialiasing(Settings& settings, const LightModel& model) {
    if (model.specular == SpecularWay::stored || settings.is("specular-antialiasing", "off"))
        return;
    if (settings.given("specular-antialiasing"))
        throw UsageError(fmt::format("--set specular-antialiasing=on: specular={} does not take the stored roughness",
                                     settings.get("specular")));
    settings.resolve("specular-antialiasing", "off");
}

void choose_fresnel(Settings& settings, LightModel& model) {
    if (settings.given("model") && settings.shading() == Shading::phong)
        settings.refuse_without_effect(); // before what a form of Fresnel would need
    if (settings.is("model", "auto"))
        settings.resolve("model", model.packed() ? "mono" : model.has_alpha() ? "weighted" : "nv");
    const std::string& fresnel = settings.get("model");
    if (fresnel == "full")
        throw UsageError("--set model=full: a light buffer has no Fresnel of each light; renderer "
                         "reference has");
    if (model.packed() != (fresnel == "mono"))
        throw UsageError("--set model=" + fresnel + ": " +
                         (model.packed() ? "a packed light buffer holds model=mono only"
                                         : "needs a packed light buffer (light-buffer=packed-rgba16f)"));
    if (fresnel == "weighted" && !model.has_alpha())
        throw UsageError(fmt::format("--set model=weighted: light-buffer={} has no alpha for it (model=nv)",
                                     settings.get("light-buffer")));
    model.fresnel = fresnel == "weighted" ? FresnelModel::weighted
                    : fresnel == "nv"     ? FresnelModel::nv
                                          : FresnelModel::mono;
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
        settings.resolve("light-culling", "tiles");
    }
    settings.resolve("light-writes", once ? "once" : "blended");
}

} // namespace

std::vector<SettingInfo> light_model_settings() {
    return {{"light-buffer",
             {"rgba16f", "r11g11b10f", "rgb10a2", "rgba8", "packed-rgba16f", "packed-rgba8"},
             "rgba16f",
             "diffuse and specular pair, or specular packed into alpha (equation 8.5.2)"},
            {"light-scale",
             {"auto", "0.01 … 1000"},
             "auto",
             "rgb10a2, rgba8, packed-rgba8: the largest light that is stored; auto: from the light of each frame"},
            {"light-writes",
             {"auto", "blended", "once"},
             "auto",
             "lights blended one by one, or summed first and written once (fullscreen, tiles, clusters)"},
            light_sums_setting(),
            {"specular",
             {"stored", "luv", "fifth-channel", "luminance", "bent"},
             "stored",
             "phong: where a material's own shininess comes in"},
            {"model",
             {"auto", "weighted", "nv", "mono", "full"},
             "auto",
             "Fresnel: mean over the lights, at N·V, or with monochrome specular (packed)"},
            {"specular-gate", {"factor", "step"}, "factor", "phong: N·L times, or only where N·L > 0"},
            {"specular-vector", {"half", "reflection"}, "half", "phong: N·H or R·V"},
            {"ambient", {"material", "light"}, "material", "a material term, or a full-screen light"}};
}

passes::LightModel light_model(Settings& settings, Shading shading) {
    LightModel model{.shading = shading,
                     .buffer = buffer_format(settings.get("light-buffer")),
                     .specular = specular_way(settings.get("specular")),
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
