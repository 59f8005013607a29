#include "picture_arguments.hpp"

namespace prelight::app {

void add_picture_options(CLI::App& sub, RenderCommand& command, RenderText& text) {
    const auto option = options_of(sub);
    sub.add_option("SCENE", command.scene, "A .gltf or .glb file, or a built-in scene: see `make`")
        ->required()
        ->type_name("");
    option("--renderer", command.renderer, "NAME", "Architecture (default light-prepass)");
    option("--preset", command.options.preset, "NAME", "A source text's own configuration");
    option("--set", text.settings, "KEY=VALUE", "One setting of the renderer; repeatable");
    option("--size", text.size, "WxH", "Picture size in pixels (default 1280x720)");
    option("--camera", command.camera, "NAME|INDEX", "Camera of the scene (default the first)");
    option("--lights", text.lights, "N", "Light count of a built-in scene; adds N random point lights to any other");
    option("--seed", text.seed, "S", "Seed of what is random (default 1)");
    option("--material", text.materials, "NAME=FILE",
           "Shade the glTF material NAME with a GLSL file of your own; repeatable (docs/materials.md)");
    add_environment_options(option, text.environment);
    add_reading_options(sub, option, text.reading);
    add_view_options(option, text.view);
    option("--msaa", text.msaa, "N", "Samples per pixel (default 1; render: what makes edges smooth)");
    option("--shading", text.shading, "MODEL", "ggx or phong (default: the preset's, else ggx)");
    option("--tonemap", text.tonemap, "CURVE", "pbr-neutral (default), aces or none");
    option("--exposure", text.exposure, "EV|auto",
           "Multiplies light by 2^EV (default 0); auto: what suits the picture");
    option("--device", command.device, "DEVICE", "auto (default), cpu, an index or a name");
    sub.add_flag("--validate", command.validate, "Run with Vulkan validation; any message is a failure");
}

void add_file_options(CLI::App& sub, RenderCommand& command, RenderText& text) {
    const auto option = options_of(sub);
    option("--view", text.views, "BUFFER[=FILE]",
           "Write this buffer in place of the picture; with =FILE.png, beside it; repeatable");
    option("--stats", text.stats, "FILE", "Write the run's figures as JSON");
    sub.add_flag("--count-pairs", command.options.count_pairs,
                 "Count light x pixel pairs for --stats (not for timing)");
    sub.add_flag("--pass-cpu", command.options.pass_cpu,
                 "Each pass's CPU time for --stats: as many frames more, each pass submitted alone");
}

void add_moment_options(CLI::App& sub, RenderCommand& command, RenderText& text) {
    const auto option = options_of(sub);
    option("--time", text.time, "SECONDS", "Moment of the scene's animations (default: at rest)");
    option("--animation", command.animation, "NAME|INDEX",
           "Only this animation of the scene (default all), at --time or else at 0 s");
}

void finish_picture(RenderCommand& command, const RenderText& text) {
    std::tie(command.options.width, command.options.height) = parse_size("--size", text.size);
    if (!text.shading.empty())
        command.options.shading = parse_shading(text.shading);
    command.options.tonemap =
        parse_word<Tonemap>("--tonemap", text.tonemap,
                            {{"pbr-neutral", Tonemap::pbr_neutral}, {"aces", Tonemap::aces}, {"none", Tonemap::none}});
    take_exposure(command, text.exposure);
    if (!text.msaa.empty())
        command.options.msaa = parse_count("--msaa", text.msaa, 1);
    command.seed = parse_seed("--seed", text.seed);
    if (!text.lights.empty())
        command.lights = parse_count("--lights", text.lights, 1);
    for (const std::string& setting : text.settings) {
        const auto [key, value] = parse_pair("--set", setting);
        command.options.settings[key] = value;
    }
    for (const std::string& material : text.materials) {
        const auto [name, file] = parse_pair("--material", material);
        command.materials.emplace_back(name, file);
    }
    command.environment = parse_environment(text.environment);
    command.reading = parse_reading(text.reading);
    command.framing = parse_view(text.view, command.camera);
    command.output = text.output;
    command.stats = text.stats;
    take_views(command, text.views);
}

} // namespace prelight::app
