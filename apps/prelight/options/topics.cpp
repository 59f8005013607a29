// `prelight help TOPIC`.
#include "../renderer_info.hpp"
#include "help.hpp"
#include "suggestion.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <map>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <setting_values/needs.hpp>

namespace prelight::app {
namespace {

constexpr size_t topic_width = 100;

constexpr std::array variables{
    VariableRow{"NO_COLOR", "Set to anything: no colours and no bold text on a terminal"},
    VariableRow{"XDG_CACHE_HOME", "Where the folder prelight/ is kept: pipelines, custom materials, the finished steps "
                                  "of an interrupted compare (default ~/.cache)"},
    VariableRow{"PRELIGHT_STANDSTILL", "Seconds without any progress after which a run gives up; 0: never (default "
                                       "60)"},
    VariableRow{"VK_DRIVER_FILES", "Read by the Vulkan loader: the drivers to look at, as files of JSON"},
    VariableRow{"TERM", "dumb: as NO_COLOR"},
};

constexpr std::array statuses{
    StatusRow{"0", "Done"},
    StatusRow{"1", "The work failed; one line on stderr says which file, what, and why"},
    StatusRow{"2", "Wrong usage; one line on stderr says which argument, and why"},
    StatusRow{"signal", "Interrupted (Ctrl-C and the like): as a shell shows it, 128 and the signal's number"},
};

std::string scenes_text() {
    std::string text =
        "SCENE is a .gltf or .glb file, or one of the built-in scenes. --lights sets the number of their "
        "lights,\n1 to 65536; to any other scene it adds so many.\n\n";
    for (const BuiltinScene& scene : builtin_scenes())
        text += two_columns(scene.name, fmt::format("{} ({} lights)", scene.description, scene.default_lights),
                            topic_width);
    return text;
}

std::string environments_text() {
    std::string text = "--environment takes a picture twice as wide as high (.hdr, .exr, .png), none, or one of the "
                       "built-in ones:\n\n";
    for (const BuiltinEnvironment& one : builtin_environments())
        text += two_columns(one.name, one.description, topic_width);
    return text;
}

std::string variables_text() {
    std::string text;
    for (const VariableRow& row : variables)
        text += two_columns(row.name, row.text, topic_width);
    return text;
}

std::string statuses_text() {
    std::string text;
    for (const StatusRow& row : statuses)
        text += two_columns(row.status, row.text, topic_width);
    return text + "\nFiles appear under their name only when they are whole.\n";
}

std::string renderers_text() {
    std::string text = "--renderer takes one of these; `prelight help NAME` shows its settings, views and presets.\n\n";
    for (const RendererInfo& info : renderer_infos())
        text += two_columns(info.name, info.description, topic_width);
    return text;
}

/// One setting, wherever it means the same.
struct SettingOf {
    SettingInfo info;
    std::vector<std::string> renderers;
};

std::map<std::string, std::vector<SettingOf>> all_settings() {
    std::map<std::string, std::vector<SettingOf>> all;
    for (const RendererInfo& info : renderer_infos())
        for (const SettingInfo& setting : info.settings) {
            std::vector<SettingOf>& known = all[setting.key];
            const auto same = std::ranges::find_if(known, [&](const SettingOf& one) {
                return one.info.values == setting.values && one.info.default_value == setting.default_value;
            });
            if (same == known.end())
                known.push_back({setting, {info.name}});
            else
                same->renderers.push_back(info.name);
        }
    return all;
}

std::string setting_text(const SettingOf& setting) {
    std::string text =
        fmt::format("  {} = {}   (default {})\n      of {}\n", setting.info.key, fmt::join(setting.info.values, " | "),
                    setting.info.default_value, fmt::join(setting.renderers, ", "));
    for (const std::string& line : wrapped(setting.info.description, topic_width - 6))
        text += "      " + line + "\n";
    for (const SettingNeed& need : setting.info.needs)
        text += fmt::format("      needs {}\n", need_text(need));
    return text;
}

std::string settings_text() {
    std::string text = "--set KEY=VALUE, where the renderer has the setting:\n\n";
    for (const auto& [key, settings] : all_settings())
        for (const SettingOf& setting : settings)
            text += setting_text(setting);
    return text;
}

std::string option_text(const std::string& name) {
    std::string text;
    for (const OptionRow& row : option_table()) {
        if (row.long_name() != name && row.short_name() != name)
            continue;
        std::vector<std::string_view> commands;
        for (const CommandRow& command : command_table())
            if (command.bits & row.commands)
                commands.push_back(command.name);
        text += fmt::format("{}   (of {})\n", row.usage(), fmt::join(commands, ", "));
        for (const std::string& line : wrapped(row.help, topic_width - 6))
            text += "      " + line + "\n";
    }
    return text;
}

struct Topic {
    std::string_view name, summary;
    std::function<std::string()> text;
};

const std::vector<Topic>& topics() {
    static const std::vector<Topic> all{
        {"scenes", "the built-in scenes", scenes_text},
        {"settings", "what --set takes, of every renderer", settings_text},
        {"renderers", "what --renderer takes", renderers_text},
        {"environments", "what --environment takes", environments_text},
        {"environment variables", "what the program reads of its environment", variables_text},
        {"exit status", "0, 1 and 2", statuses_text},
    };
    return all;
}

std::string list_of_topics() {
    std::string text = "prelight help TOPIC explains one of these:\n\n";
    for (const Topic& topic : topics())
        text += two_columns(topic.name, topic.summary, topic_width);
    text += two_columns("a command", fmt::format("{}", fmt::join(command_names(), ", ")), topic_width);
    text += two_columns("an option", "as in `prelight help --exposure`", topic_width);
    text += two_columns("a renderer", "as in `prelight help deferred`", topic_width);
    return text + two_columns("a setting", "as in `prelight help light-culling`", topic_width);
}

} // namespace

std::span<const VariableRow> environment_variables() { return variables; }

std::span<const StatusRow> exit_statuses() { return statuses; }

std::vector<std::string> subject_names() {
    std::vector<std::string> names;
    for (const Topic& topic : topics())
        std::ranges::replace(names.emplace_back(topic.name), ' ', '-');
    return names;
}

std::string topic_help(const std::string& given) {
    if (given.empty())
        return list_of_topics();
    std::string spaced = given; // exit-status
    if (!given.starts_with('-'))
        std::ranges::replace(spaced, '-', ' ');
    for (const Topic& topic : topics())
        if (topic.name == spaced)
            return topic.text();
    const CommandRow* command = find_command(given);
    if (command && !command->hidden)
        return command_help(*command);
    const std::string option = given.starts_with('-') ? given : "--" + given;
    const std::string of_option = option_text(option);
    std::string text = given.starts_with('-') ? of_option : std::string();
    std::vector<std::string> known = command_names();
    for (const Topic& topic : topics())
        known.emplace_back(topic.name);
    for (const RendererInfo& info : renderer_infos()) {
        if (info.name == given)
            return renderer_text(info);
        known.push_back(info.name);
    }
    const auto settings = all_settings();
    for (const auto& [key, of_key] : settings)
        known.push_back(key);
    for (const OptionRow& row : option_table())
        known.push_back(row.long_name());
    if (const auto found = settings.find(given); found != settings.end())
        for (const SettingOf& setting : found->second)
            text += setting_text(setting);
    if (text.empty())
        text = of_option;
    if (text.empty())
        throw UsageError(fmt::format("{}: no topic{} (prelight help lists them)", given, did_you_mean(given, known)));
    return text;
}

} // namespace prelight::app
