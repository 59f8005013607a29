#include "against_reference.hpp"
#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace prelight {
namespace {

bool is(const Shot& shot, const char* key, const char* value) {
    const auto found = shot.settings.find(key);
    return found != shot.settings.end() && found->second == value;
}

std::string from_environment(const char* name, const char* absent) {
    const char* const value = std::getenv(name);
    return value ? value : absent;
}

/// For all tests of the process. Ends before that does: the layer's own statics must still be there.
Device* keep(std::unique_ptr<Device> device) {
    struct Holder : testing::Environment {
        std::unique_ptr<Device> device;
        void TearDown() override { device.reset(); }
    };
    auto* const holder = new Holder;
    holder->device = std::move(device);
    testing::AddGlobalTestEnvironment(holder);
    return holder->device.get();
}

bool has_own_shaders(const World& world) {
    const std::vector<Material>& materials = world.scene->materials;
    return std::any_of(materials.begin(), materials.end(), [](const Material& one) { return one.shader != nullptr; });
}

} // namespace

void PrintTo(const Form& form, std::ostream* out) { *out << form.name; }

Device& test_device() {
    static Device* const device = keep(Device::create(
        {.select = from_environment("PRELIGHT_TEST_DEVICE", "cpu"),
         .validate = from_environment("PRELIGHT_TEST_VALIDATION", "on") != "off"})); // scripts/gpu-report.sh
    return *device;
}

Device* swiftshader_device() {
    static Device* const device = [] {
        const char* icd = "/usr/lib/chromium/vk_swiftshader_icd.json";
        if (!std::filesystem::exists(icd))
            return static_cast<Device*>(nullptr);
        setenv("VK_DRIVER_FILES", icd, 1);
        Device* const made = keep(Device::create({.select = "auto", .validate = true}));
        unsetenv("VK_DRIVER_FILES");
        return made;
    }();
    return device;
}

RenderOptions options_of(const Shot& shot) {
    RenderOptions options;
    options.width = shot.width;
    options.height = shot.height;
    options.exposure = shot.exposure;
    options.msaa = shot.samples;
    options.shading = shot.shading;
    options.settings = shot.settings;
    options.settings.emplace("texture-filter", "bilinear");
    options.views = {"linear"};
    return options;
}

ReferenceForm form_of(const Shot& shot) {
    using Fresnel = ReferenceForm::Fresnel;
    using Specular = ReferenceForm::Specular;
    ReferenceForm form;
    form.specular = is(shot, "specular", "luv")             ? Specular::luv
                    : is(shot, "specular", "fifth-channel") ? Specular::fifth_channel
                    : is(shot, "specular", "luminance")     ? Specular::luminance
                    : is(shot, "specular", "bent")          ? Specular::bent
                                                            : Specular::stored;
    const bool packed = is(shot, "light-buffer", "packed-rgba16f") || is(shot, "light-buffer", "packed-rgba8") ||
                        form.specular != Specular::stored;
    const bool no_alpha = is(shot, "light-buffer", "r11g11b10f") || is(shot, "light-buffer", "rgb10a2");
    form.shading = shot.shading;
    form.fresnel = packed                                ? Fresnel::mono
                   : is(shot, "model", "nv") || no_alpha ? Fresnel::nv
                   : shot.renderer == "light-prepass"    ? Fresnel::weighted
                   : shot.renderer == "inferred"         ? Fresnel::weighted
                                                         : Fresnel::full;
    form.mono_specular = packed;
    form.gate_by_step = is(shot, "specular-gate", "step");
    form.reflection_vector = is(shot, "specular-vector", "reflection");
    form.ambient_as_light = is(shot, "ambient", "light");
    form.shadows = is(shot, "shadows", "on");
    using Through = ReferenceForm::TransparentShadows;
    form.transparent_shadows = is(shot, "transparent-shadows", "opaque") ? Through::opaque
                               : is(shot, "transparent-shadows", "none") ? Through::none
                                                                         : Through::filtered;
    form.specular_antialiasing = !is(shot, "specular-antialiasing", "off") && form.specular == Specular::stored;
    if (shot.settings.contains("ssao") && !is(shot, "ssao", "off"))
        form.occlusion_radius = shot.settings.contains("ssao-radius") ? std::stod(shot.settings.at("ssao-radius")) : 1;
    form.bilinear_level0 = !shot.settings.contains("texture-filter") || is(shot, "texture-filter", "bilinear");
    form.own_shaders = shot.renderer == "deferred"    ? ReferenceForm::OwnShaders::no_lights
                       : shot.renderer == "multipass" ? ReferenceForm::OwnShaders::each_light
                                                      : ReferenceForm::OwnShaders::sums;
    std::map<std::string, std::string> in_force = shot.settings;
    in_force.emplace("transparency", "lists");
    if (shot.renderer == "inferred") {
        in_force.emplace("inferred-scale", "5/8");
        in_force.emplace("inferred-layers", "on");
    }
    if (shot.renderer == "light-prepass" || shot.renderer == "deferred")
        in_force.emplace("msaa-light", "edges");
    if (shot.renderer == "deferred")
        in_force.emplace("g-buffer", "wide");
    in_force.emplace("msaa-material", "fragment");
    const ReferenceForm known = reference_form(shot.shading, in_force, shot.samples);
    form.samples = known.samples;
    form.transparency = known.transparency;
    form.half_samples = known.half_samples;
    form.inferred_scale = known.inferred_scale;
    return form;
}

Image render_linear(Device& device, const Shot& shot) { return view_of(shot, "linear", device); }

Image view_of(const Shot& shot, const char* view, Device& device) {
    RenderOptions options = options_of(shot);
    options.views = {view};
    const auto renderer = create_renderer(shot.renderer, &device, options);
    renderer->set_world(*shot.world);
    renderer->render(shot.camera);
    return renderer->read(view);
}

Rendered render_with(const World& world, const PlacedCamera& camera, const RenderOptions& options,
                     const std::string& renderer) {
    const auto made = create_renderer(renderer, &test_device(), options);
    made->set_world(world);
    made->render(camera);
    Image linear = made->read("linear");
    return {std::move(linear), made->stats()};
}

void expect_same_with_less_geometry(Shot shot) {
    using Ways = std::map<std::string, std::string>;
    for (const char* name : {"light-prepass", "z-prepass"}) {
        SCOPED_TRACE(name);
        shot.renderer = name;
        shot.settings = {{"index-trimming", "off"}, {"draws", "direct"}, {"frustum-culling", "off"}};
        const Image all = render_linear(test_device(), shot);
        for (const Ways& less :
             {Ways{{"index-trimming", "host"}},
              Ways{{"index-trimming", "device"}, {"material-trimming", "depth"}, {"occlusion", "queries"}},
              Ways{{"draws", "instanced"}, {"material-trimming", "depth"}}}) {
            shot.settings = less;
            EXPECT_EQ(render_linear(test_device(), shot).pixels, all.pixels) << less.begin()->second;
        }
    }
    expect_validation_clean(test_device());
}

Rendered render_counting_pairs(const Shot& shot, uint32_t frames) {
    RenderOptions options = options_of(shot);
    options.count_pairs = true;
    const auto renderer = create_renderer(shot.renderer, &test_device(), options);
    renderer->set_world(*shot.world);
    renderer->render(shot.camera, frames);
    Stats stats = renderer->stats();
    return {renderer->read("linear"), std::move(stats)};
}

void save_when_wanted(const Image& picture, const ReferencePicture& reference) {
    if (const char* folder = std::getenv("PRELIGHT_TEST_PICTURES")) {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = std::string(info->test_suite_name()) + "." + info->name();
        std::replace(name.begin(), name.end(), '/', '-');
        const auto base = std::filesystem::path(folder) / name;
        save_png(tonemap(picture, Tonemap::none), base.string() + ".png");
        save_png(tonemap(reference.linear, Tonemap::none), base.string() + ".reference.png");
        Image difference(picture.width, picture.height);
        const std::vector<uint8_t> out = reference.left_out();
        for (size_t i = 0; i < difference.pixels.size(); ++i)
            difference.pixels[i] =
                out[i] ? glm::vec3(0, 0, 0.3f) : glm::abs(picture.pixels[i] - reference.linear.pixels[i]) * 20.0f;
        save_png(difference, base.string() + ".difference.png");
    }
}

Comparison against_reference(Device& device, const Shot& shot) {
    const Image picture = render_linear(device, shot);
    const ReferencePicture reference =
        render_reference(*shot.world, shot.camera, shot.width, shot.height, shot.exposure, form_of(shot));
    save_when_wanted(picture, reference);
    return compare_pixels(picture, reference.linear, reference.left_out());
}

void expect_validation_clean(Device& device) {
    static std::map<const Device*, size_t> seen;
    const std::vector<std::string> messages = device.validation_messages();
    for (size_t i = seen[&device]; i < messages.size(); ++i)
        ADD_FAILURE() << "validation: " << messages[i];
    seen[&device] = messages.size();
}

void expect_agrees(const Shot& shot, const Bound& bound) {
    expect_within(against_reference(test_device(), shot), bound);
    expect_validation_clean(test_device());
}

void expect_within(const Comparison& c, const Bound& bound) {
    EXPECT_GE(c.psnr, bound.psnr);
    EXPECT_LE(c.off_share, bound.off_share);
    EXPECT_LE(c.block, bound.block) << "at pixel " << c.block_x << ", " << c.block_y;
    EXPECT_LE(c.left_out_share, bound.left_out);
    std::printf("    %.1f dB, %.3f %% off, block %.2f/255, %.1f %% left out\n", c.psnr, c.off_share * 100, c.block,
                c.left_out_share * 100);
}

void expect_within_on_edges(const Image& picture, const ReferencePicture& reference, const Bound& bound,
                            const EdgeBound& edges) {
    const std::vector<uint8_t> out = reference.left_out();
    std::vector<uint8_t> others = out;
    size_t judged = 0;
    for (size_t i = 0; i < others.size(); ++i) {
        others[i] = out[i] || !reference.edge[i];
        judged += !others[i];
    }
    expect_within(compare_pixels(picture, reference.linear, out), bound);
    const double psnr = compare_pixels(picture, reference.linear, others).psnr;
    std::printf("    %zu edge pixels, %.1f dB there\n", judged, psnr);
    EXPECT_GE(judged, edges.pixels);
    EXPECT_GE(psnr, edges.psnr);
}

const ReferencePicture& References::of(const Shot& shot) {
    ReferenceForm form = form_of(shot);
    if (!has_own_shaders(*shot.world))
        form.own_shaders = ReferenceForm::OwnShaders::sums; // whatever the form, where there are none
    for (const Known& one : known_)
        if (one.form == form && one.exposure == shot.exposure)
            return one.picture;
    return known_
        .emplace_back(form, shot.exposure,
                      render_reference(*shot.world, shot.camera, shot.width, shot.height, shot.exposure, form))
        .picture;
}

void References::expect_agrees(const Shot& shot, const Bound& bound) {
    SCOPED_TRACE(shot.renderer);
    const Image picture = render_linear(test_device(), shot);
    const ReferencePicture& reference = of(shot);
    save_when_wanted(picture, reference);
    expect_within(compare_pixels(picture, reference.linear, reference.left_out()), bound);
    expect_validation_clean(test_device());
}

} // namespace prelight
