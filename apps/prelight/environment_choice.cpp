#include "environment_choice.hpp"

#include "argument.hpp"
#include "colour.hpp"
#include "options/given.hpp"
#include "options/suggestion.hpp"

#include <algorithm>
#include <fmt/ranges.h>
#include <numbers>
#include <prelight/scene_io.hpp>

namespace prelight::app {
namespace {

/// A file as it was read last.
class KeptEnvironment {
public:
    const Environment& get(const std::filesystem::path& file) {
        std::error_code missing;
        const auto time = std::filesystem::last_write_time(file, missing);
        if (!environment_ || missing || time != time_)
            environment_ = load_environment(file);
        time_ = time;
        return *environment_;
    }

private:
    std::optional<Environment> environment_;
    std::filesystem::file_time_type time_{};
};

/// A built-in name, "none", or empty for what must be a file.
std::string environment_name(const std::string& text) {
    std::vector<std::string> names{"none"};
    for (const BuiltinEnvironment& one : builtin_environments())
        names.emplace_back(one.name);
    if (std::ranges::find(names, text) != names.end())
        return text;
    std::error_code ignored;
    if (!text.empty() && std::filesystem::path(text).extension().empty() && !std::filesystem::exists(text, ignored))
        throw UsageError(fmt::format("--environment {}: neither a file nor one of {}{}", text, fmt::join(names, ", "),
                                     did_you_mean(text, names)));
    return {};
}

void take_background(const std::string& text, EnvironmentChoice& choice) {
    const std::vector<std::pair<std::string_view, Background>> words{{"environment", Background::environment},
                                                                     {"backdrop", Background::backdrop},
                                                                     {"black", Background::black},
                                                                     {"transparent", Background::transparent}};
    const auto word = std::ranges::find(words, std::string_view(text), [](const auto& one) { return one.first; });
    if (word != words.end()) {
        choice.background = word->second;
    } else if (const std::optional<glm::vec3> colour = find_colour(text)) {
        choice.background = Background::colour;
        choice.colour = *colour;
    } else {
        std::vector<std::string> known = colour_names();
        for (const auto& [name, background] : words)
            known.emplace_back(name);
        throw UsageError(fmt::format("--background {}: not one of environment, backdrop, black, transparent, nor a "
                                     "colour as in #ff8800 or orange{}",
                                     text, did_you_mean(text, known)));
    }
}

/// The environment that the scene is to have, before anything is changed about it; null: none.
std::shared_ptr<const Environment> chosen(const EnvironmentChoice& choice, KeptEnvironment& kept, const Scene& scene,
                                          bool studio_where_dark) {
    if (!choice.file.empty())
        return std::make_shared<const Environment>(kept.get(choice.file));
    if (choice.name == "none")
        return nullptr;
    if (!choice.name.empty())
        return std::make_shared<const Environment>(make_environment(choice.name));
    if (studio_where_dark && !is_lit(scene))
        return std::make_shared<const Environment>(make_environment("studio"));
    return scene.environment;
}

} // namespace

EnvironmentChoice parse_environment(const Given& given) {
    const std::string environment = given.text("--environment");
    EnvironmentChoice choice{
        .name = environment_name(environment), .file = {}, .intensity = {}, .rotation = {}, .background = {}};
    if (choice.name.empty())
        choice.file = environment;
    if (given.has("--environment-intensity"))
        choice.intensity =
            static_cast<float>(parse_number("--environment-intensity", given.text("--environment-intensity"), 0, 1e6));
    if (given.has("--environment-rotation"))
        choice.rotation = parse_number("--environment-rotation", given.text("--environment-rotation"), -36000, 36000) *
                          std::numbers::pi / 180;
    if (given.has("--background"))
        take_background(given.text("--background"), choice);
    return choice;
}

void refuse_see_through(const EnvironmentChoice& choice, const Given& given) {
    if (choice.see_through())
        throw UsageError(fmt::format("--background {}: prelight render alone has it, not {}",
                                     given.text("--background"), given.command().name));
}

SceneEdit environment_edit(const EnvironmentChoice& choice, bool studio_where_dark) {
    return [choice, studio_where_dark, kept = std::make_shared<KeptEnvironment>()](Scene& scene) {
        scene.environment = chosen(choice, *kept, scene, studio_where_dark);
        if (!choice.intensity && !choice.rotation && !choice.background)
            return;
        if (!scene.environment && choice.see_through() && !choice.intensity && !choice.rotation)
            return; // nothing is seen there anyway
        if (!scene.environment)
            throw UsageError(fmt::format("{}: {} has no environment (--environment NAME|FILE gives it one)",
                                         choice.intensity  ? "--environment-intensity"
                                         : choice.rotation ? "--environment-rotation"
                                                           : "--background",
                                         scene.name));
        Environment environment = *scene.environment;
        environment.intensity = choice.intensity.value_or(environment.intensity);
        environment.rotation = choice.rotation.value_or(environment.rotation);
        if (choice.background) {
            environment.background = *choice.background != Background::black && !choice.see_through();
            environment.backdrop = *choice.background == Background::backdrop ? soft_backdrop() : Image();
        }
        scene.environment = std::make_shared<const Environment>(std::move(environment));
    };
}

} // namespace prelight::app
