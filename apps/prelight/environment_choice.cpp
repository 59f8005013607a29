#include "environment_choice.hpp"

#include "argument.hpp"

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

} // namespace

EnvironmentChoice parse_environment(const EnvironmentText& text) {
    EnvironmentChoice choice{.file = text.file, .intensity = {}, .rotation = {}, .background = {}};
    if (!text.intensity.empty())
        choice.intensity = static_cast<float>(parse_number("--environment-intensity", text.intensity, 0, 1e6));
    if (!text.rotation.empty())
        choice.rotation = parse_number("--environment-rotation", text.rotation, -36000, 36000) * std::numbers::pi / 180;
    if (!text.background.empty())
        choice.background = parse_word<bool>("--background", text.background, {{"environment", true}, {"black", false}});
    return choice;
}

SceneEdit environment_edit(const EnvironmentChoice& choice) {
    return [choice, kept = std::make_shared<KeptEnvironment>()](Scene& scene) {
        if (choice.file.empty() && !choice.intensity && !choice.rotation && !choice.background)
            return;
        if (choice.file.empty() && !scene.environment)
            throw UsageError(fmt::format("{}: {} has no environment (--environment FILE gives it one)",
                                         choice.intensity  ? "--environment-intensity"
                                         : choice.rotation ? "--environment-rotation"
                                                           : "--background",
                                         scene.name));
        Environment environment = choice.file.empty() ? *scene.environment : kept->get(choice.file);
        environment.intensity = choice.intensity.value_or(environment.intensity);
        environment.rotation = choice.rotation.value_or(environment.rotation);
        environment.background = choice.background.value_or(environment.background);
        scene.environment = std::make_shared<const Environment>(std::move(environment));
    };
}

} // namespace prelight::app
