// No setting is taken in silence where it makes no difference: it is refused with what it needs. And a preset shades as
// its source text does.
#include "garden.hpp"
#include <prelight/error.hpp>
#include <set>

namespace prelight {
namespace {

using testing::HasSubstr;

std::string refusal_by(const RendererInfo& info, const RenderOptions& options) {
    try {
        create_renderer(info.name, info.needs_device ? &test_device() : nullptr, options);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "accepted";
}

/// A value that is not the default: a word, or a number of the range.
std::string another_value(const SettingInfo& setting) {
    for (const std::string& value : setting.values)
        if (value != setting.default_value)
            return value.find(" … ") == std::string::npos ? value : value.substr(0, value.find(" "));
    return setting.default_value;
}

const SettingInfo& setting_of(const RendererInfo& info, const std::string& key) {
    return *std::find_if(info.settings.begin(), info.settings.end(),
                         [&](const SettingInfo& s) { return s.key == key; });
}

void meet(const SettingNeed& need, RenderOptions& options) {
    if (need.key == "shading")
        options.shading = need.values[0] == "phong" ? Shading::phong : Shading::ggx;
    else if (need.key == "msaa")
        options.msaa = static_cast<uint32_t>(std::stoul(need.values.back()));
    else
        options.settings[need.key] = need.values[0];
}

TEST(Settings, WithoutEffectAreRefusedWithWhatTheyNeed) {
    size_t seen = 0;
    for (const RendererInfo& info : renderer_infos())
        for (const SettingInfo& setting : info.settings)
            for (const SettingNeed& unmet : setting.needs) {
                SCOPED_TRACE(info.name + " " + setting.key + " needs " + unmet.key);
                RenderOptions options{.width = 16, .height = 16};
                options.settings[setting.key] = another_value(setting);
                for (const SettingNeed& need : setting.needs) {
                    // What needs the same itself would be refused first: its default meets the need.
                    const std::vector<SettingNeed> its =
                        need.of_options() ? std::vector<SettingNeed>() : setting_of(info, need.key).needs;
                    const bool too = std::any_of(its.begin(), its.end(),
                                                 [&](const SettingNeed& other) { return other.key == unmet.key; });
                    if (&need != &unmet && !too)
                        meet(need, options);
                }
                if (unmet.key == "shading") {
                    options.shading = unmet.values[0] == "ggx" ? Shading::phong : Shading::ggx;
                } else if (unmet.key == "msaa") {
                    options.msaa = unmet.values.back() == "1" ? 4 : 1;
                } else {
                    for (const SettingNeed& need : setting_of(info, unmet.key).needs)
                        meet(need, options);
                    for (const std::string& value : setting_of(info, unmet.key).values)
                        if (std::find(unmet.values.begin(), unmet.values.end(), value) == unmet.values.end() &&
                            value != "auto")
                            options.settings[unmet.key] = value;
                }
                const std::string line = refusal_by(info, options);
                EXPECT_THAT(line, HasSubstr("--set " + setting.key + "="));
                EXPECT_THAT(line,
                            HasSubstr(unmet.of_options() ? "--" + unmet.key + " " + unmet.values[0] : unmet.key + "="));
                EXPECT_THAT(line, testing::Not(HasSubstr("\n")));
                ++seen;
            }
    EXPECT_GE(seen, 40u);
}

TEST(Settings, AreTakenWhereTheirNeedsAreMet) {
    for (const RendererInfo& info : renderer_infos())
        for (const SettingInfo& setting : info.settings) {
            if (setting.needs.empty())
                continue;
            SCOPED_TRACE(info.name + " " + setting.key);
            RenderOptions options{.width = 16, .height = 16};
            for (const SettingNeed& need : setting.needs)
                meet(need, options);
            options.settings[setting.key] = another_value(setting);
            if (setting.key == "shadow-memory" && info.name != "z-prepass")
                options.settings["light-culling"] = "volumes"; // maps are drawn light by light
            EXPECT_EQ(refusal_by(info, options), "accepted");
            for (const SettingNeed& need : setting.needs)
                if (!need.or_view.empty()) { // a view does as well
                    options.settings.erase(need.key);
                    options.views = {need.or_view};
                    EXPECT_EQ(refusal_by(info, options), "accepted");
                }
        }
}

TEST(Settings, ThatSayWhatIsSoAnywayAreTaken) {
    for (const RendererInfo& info : renderer_infos())
        for (const SettingInfo& setting : info.settings) {
            RenderOptions options{.width = 16, .height = 16, .settings = {{setting.key, setting.default_value}}};
            EXPECT_EQ(refusal_by(info, options), "accepted") << info.name << " " << setting.key;
        }
}

struct OfAText {
    const char *renderer, *preset;
};

TEST(Presets, ShadeAsTheirSourceTextUnlessToldOtherwise) {
    Garden garden;
    garden.add_lights(3, 5, 4);
    for (const OfAText& text : {OfAText{"light-prepass", "engel"},
                                {"light-prepass", "round2"},
                                {"light-prepass", "prelighting"},
                                {"deferred", "killzone2"}}) {
        SCOPED_TRACE(text.preset);
        const auto shading_of = [&](std::optional<Shading> asked) {
            const auto renderer = create_renderer(text.renderer, &test_device(),
                                                  {.width = 16, .height = 16, .shading = asked, .preset = text.preset});
            renderer->set_world(garden.world);
            renderer->render(garden.camera);
            return renderer->stats().shading;
        };
        EXPECT_EQ(shading_of({}), Shading::phong);
        EXPECT_EQ(shading_of(Shading::ggx), Shading::ggx);
        EXPECT_EQ(shading_of(Shading::phong), Shading::phong);
    }
    for (const RendererInfo& info : renderer_infos()) {
        EXPECT_EQ(shading_in_force(info, {}), Shading::ggx) << info.name;
        for (const auto& [preset, shading] : info.preset_shading)
            EXPECT_THAT(info.presets, testing::Contains(preset)) << info.name;
    }
}

TEST(Presets, WhatIsWithoutEffectInTheOtherModelGivesWayAndIsTold) {
    Garden garden;
    const auto stats_of = [&](const RenderOptions& options) {
        const auto renderer = create_renderer("light-prepass", &test_device(), options);
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        return renderer->stats();
    };
    const Stats ggx = stats_of({.width = 16, .height = 16, .shading = Shading::ggx, .preset = "round2"});
    EXPECT_EQ(ggx.settings.at("specular-vector"), "half");
    EXPECT_THAT(ggx.notes, testing::Contains(HasSubstr(
                               "specular-vector=reflection: needs --shading phong, and it is ggx (preset round2)")));
    const Stats tiles =
        stats_of({.width = 16, .height = 16, .preset = "round2", .settings = {{"light-culling", "tiles"}}});
    EXPECT_EQ(tiles.settings.at("volume-depth-test"), "on");
    EXPECT_THAT(tiles.notes,
                testing::Contains(
                    HasSubstr("volume-depth-test=off: needs light-culling=volumes, and it is tiles (preset round2)")));
    EXPECT_EQ(tiles.settings.at("model"), "mono");
}

TEST(Settings, WhatWasChosenIsToldWithItsReason) {
    Garden garden;
    const auto choices_of = [&](const std::string& name, const RenderOptions& options) {
        const auto renderer = create_renderer(name, &test_device(), options);
        renderer->set_world(garden.world);
        renderer->render(garden.camera);
        std::map<std::string, SettingChoice> all;
        const Stats stats = renderer->stats();
        for (const SettingChoice& choice : stats.choices) {
            EXPECT_FALSE(choice.why.empty()) << choice.key;
            EXPECT_NE(choice.asked, choice.taken) << choice.key;
            EXPECT_EQ(stats.settings.at(choice.key), choice.taken);
            all.emplace(choice.key, choice);
        }
        // Decided pass by pass, or where a scene has layers.
        const std::set<std::string> of_a_pass{"light-scale", "list-shading", "depth-bounds", "peeled-layers",
                                              "layer-light"};
        for (const auto& [key, value] : stats.settings) // no other "auto" is left, and none goes without a reason
            EXPECT_TRUE(value != "auto" || of_a_pass.contains(key)) << key;
        return all;
    };
    const auto ours = choices_of("light-prepass", {.width = 16, .height = 16});
    ASSERT_TRUE(ours.contains("light-culling"));
    EXPECT_EQ(ours.at("light-culling").asked, "auto");
    EXPECT_EQ(ours.at("light-culling").taken, "tiles");
    EXPECT_EQ(ours.at("texture-filter").taken, "trilinear");
    EXPECT_EQ(ours.at("light-writes").taken, "once");
    const auto blended =
        choices_of("light-prepass", {.width = 16, .height = 16, .settings = {{"light-culling", "volumes"}}});
    EXPECT_FALSE(blended.contains("light-culling")) << "asked for by name";
    EXPECT_EQ(blended.at("light-writes").taken, "blended");
    for (const char* name : {"deferred", "multipass", "z-prepass"})
        choices_of(name, {.width = 16, .height = 16});
}

} // namespace
} // namespace prelight
