#include "picture_command.hpp"

#include "argument.hpp"
#include "options/given.hpp"
#include "renderer_info.hpp"

namespace prelight::app {

ExposureChoice take_exposure(const Given& given, RenderOptions& options) {
    if (!given.has("--exposure"))
        return ExposureChoice::open;
    const std::string text = given.text("--exposure");
    if (text == "auto")
        return ExposureChoice::automatic;
    options.exposure = parse_number("--exposure", text, -64, 64);
    return ExposureChoice::given;
}

void take_settings(const Given& given, const RendererInfo* info, std::map<std::string, std::string>& settings) {
    for (const std::string& setting : given.all("--set")) {
        const auto [key, value] = parse_pair("--set", setting);
        if (info)
            check_setting("--set " + setting, *info, key, value);
        settings[key] = value;
    }
}

RenderCommand parse_picture(const Given& given) {
    RenderCommand command;
    command.quiet = given.has("--quiet");
    command.scene = given.text("SCENE");
    command.renderer = given.text("--renderer", command.renderer);
    const RendererInfo info = find_renderer(command.renderer);
    RenderOptions& options = command.options;
    options.preset = given.text("--preset");
    if (!options.preset.empty())
        check_preset("--preset " + options.preset, info, options.preset);
    take_settings(given, &info, options.settings);
    std::tie(options.width, options.height) = parse_size("--size", given.text("--size", "1280x720"));
    if (given.has("--shading"))
        options.shading = parse_shading(given.text("--shading"));
    options.tonemap =
        parse_word<Tonemap>("--tonemap", given.text("--tonemap", "pbr-neutral"),
                            {{"pbr-neutral", Tonemap::pbr_neutral}, {"aces", Tonemap::aces}, {"none", Tonemap::none}});
    command.exposure = take_exposure(given, options);
    if (given.has("--msaa"))
        options.msaa = parse_count("--msaa", given.text("--msaa"), 1);
    options.count_pairs = given.has("--count-pairs");
    options.pass_cpu = given.has("--pass-cpu");
    command.camera = given.text("--camera");
    command.animation = given.text("--animation");
    command.seed = parse_seed("--seed", given.text("--seed", "1"));
    if (given.has("--lights"))
        command.lights = parse_count("--lights", given.text("--lights"), 1);
    command.device = given.text("--device", command.device);
    command.validate = given.has("--validate");
    for (const std::string& material : given.all("--material"))
        command.materials.emplace_back(parse_pair("--material", material));
    command.environment = parse_environment(given);
    command.reading = parse_reading(given);
    command.framing = parse_view(given);
    command.output = given.text("--output");
    command.stats = given.text("--stats");
    take_views(command, given.all("--view"));
    return command;
}

} // namespace prelight::app
