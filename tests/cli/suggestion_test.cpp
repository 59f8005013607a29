// Misspelt words, and what is said about them.
#include "process.hpp"

#include <gmock/gmock.h>
#include <options/option_table.hpp>
#include <options/suggestion.hpp>
#include <set>
#include <terminal.hpp>

namespace prelight::test {
namespace {

using testing::HasSubstr;

TEST(Suggestion, CountsWhatHasToBeChanged) {
    EXPECT_EQ(app::edit_distance("", ""), 0u);
    EXPECT_EQ(app::edit_distance("abc", ""), 3u);
    EXPECT_EQ(app::edit_distance("kitten", "sitting"), 3u);
    EXPECT_EQ(app::edit_distance("nromals", "normals"), 1u) << "two letters that changed places are one mistake";
    EXPECT_EQ(app::edit_distance("Deferred", "deferred"), 0u);
}

TEST(Suggestion, IsTheNearestOrNone) {
    const std::vector<std::string> names{"--exposure", "--environment", "--size", "--seed"};
    EXPECT_EQ(app::closest("--exposre", names), "--exposure");
    EXPECT_EQ(app::closest("--sizes", names), "--size");
    EXPECT_EQ(app::closest("--env", names), "--environment") << "the only one that begins so";
    EXPECT_EQ(app::closest("--s", names), "") << "two begin so";
    EXPECT_EQ(app::closest("--watch", names), "");
    EXPECT_EQ(app::closest("", names), "");
    EXPECT_EQ(app::closest(std::string(100000, 'x'), names), "");
}

struct Misspelt {
    const char* name;
    std::vector<std::string> arguments;
    const char* expected;
};

void PrintTo(const Misspelt& misspelt, std::ostream* stream) { *stream << misspelt.name; }

class MisspeltWord : public testing::TestWithParam<Misspelt> {};

TEST_P(MisspeltWord, IsNamedWithWhatWasMeant) {
    const TemporaryFolder folder;
    const Result result = run(GetParam().arguments, folder.path);
    EXPECT_TRUE(failed_with(result, 2));
    EXPECT_THAT(result.err, HasSubstr(GetParam().expected));
    EXPECT_EQ(folder.entries(), 0u);
}
INSTANTIATE_TEST_SUITE_P(
    Kinds, MisspeltWord,
    testing::Values(
        Misspelt{"Command", {"rendr", "city", "-o", "a.png"}, "did you mean render?"},
        Misspelt{"Option",
                 {"render", "city", "--exposre", "2", "-o", "a.png"},
                 "prelight: --exposre: not an option of render; did you mean --exposure?"},
        Misspelt{"OptionBeforeScene",
                 {"render", "--exposre", "2", "city", "-o", "a.png"},
                 "prelight: --exposre: not an option of render; did you mean --exposure?"},
        Misspelt{"OptionWithValue", {"render", "city", "--exposre=2"}, "prelight: --exposre: not an option of render"},
        Misspelt{"TwoOptionsInTheirOrder",
                 {"render", "city", "--zise", "8x8", "--exposre", "2", "-o", "a.png"},
                 "prelight: --zise: not an option of render; did you mean --size? --exposre: not an option of render; "
                 "did you "
                 "mean --exposure?"},
        Misspelt{"OptionOfAnotherCommand",
                 {"compare", "city", "-o", "out", "--tonemap", "none"},
                 "--tonemap: not an option of compare"},
        Misspelt{"Help", {"render", "--hlep"}, "did you mean --help?"},
        Misspelt{"Scene", {"render", "citty", "-o", "a.png"}, "did you mean city?"},
        Misspelt{"SceneToMake", {"make", "lihgts", "-o", "a.glb"}, "did you mean lights?"},
        Misspelt{"SceneOrBench", {"bench", "encoding"}, "did you mean encodings?"},
        Misspelt{"Renderer", {"render", "city", "--renderer", "defered", "-o", "a.png"}, "did you mean deferred?"},
        Misspelt{"RendererToList", {"renderers", "multi-pass"}, "did you mean multipass?"},
        Misspelt{"Setting", {"render", "city", "--set", "nromals=oct32", "-o", "a.png"}, "did you mean normals?"},
        Misspelt{"SettingsInTheirOrder",
                 {"render", "city", "--set", "nromals=oct32", "--set", "light-bufer=x", "-o", "a.png"},
                 "prelight: --set nromals=oct32"},
        Misspelt{"SettingValue",
                 {"render", "city", "--set", "light-culling=cluster", "-o", "a.png"},
                 "did you mean clusters?"},
        Misspelt{"SettingOfBench", {"bench", "lights", "--set", "light-cullin=tiles"}, "did you mean light-culling?"},
        Misspelt{"SettingOfVariant",
                 {"compare", "city", "-o", "out", "--renderers", "deferred@light-culing=tiles"},
                 "did you mean light-culling?"},
        Misspelt{"Preset", {"render", "city", "--preset", "engle", "-o", "a.png"}, "did you mean engel?"},
        Misspelt{"View", {"render", "spheres", "--view", "difuse-light", "-o", "a.png"}, "did you mean diffuse-light?"},
        Misspelt{"Word", {"render", "city", "--tonemap", "acse", "-o", "a.png"}, "did you mean aces?"},
        Misspelt{"Environment", {"render", "city", "--environment", "stdio", "-o", "a.png"}, "did you mean studio?"},
        Misspelt{"Material", {"materials", "minaert"}, "did you mean minnaert?"},
        Misspelt{"Topic", {"help", "enviroment", "variables"}, "did you mean environment variables?"}),
    [](const auto& one) { return std::string(one.param.name); });

TEST(Suggestion, NothingIsGuessedForAnUnrelatedWord) {
    const TemporaryFolder folder;
    const Result result = run({"render", "city", "--frobnicate", "-o", "a.png"}, folder.path);
    EXPECT_TRUE(failed_with(result, 2));
    EXPECT_THAT(result.err, testing::Not(HasSubstr("did you mean")));
}

TEST(OptionTable, SaysOnceWhatAnOptionMeansToACommand) {
    for (const app::CommandRow& command : app::command_table()) {
        std::set<std::pair<std::string, uint32_t>> seen;
        for (const app::OptionRow* row : app::options_of(command)) {
            for (uint32_t bit = 1; bit <= command.bits; bit <<= 1)
                if (command.bits & row->commands & bit) {
                    EXPECT_TRUE(seen.emplace(row->long_name(), bit).second) << command.name << " " << row->names;
                }
            EXPECT_FALSE(row->help.empty());
            EXPECT_EQ(row->takes == app::Takes::words, !row->words.empty()) << row->names;
        }
    }
}

TEST(Help, GroupsOptions) {
    const TemporaryFolder folder;
    const Result result = run({"render", "--help"}, folder.path);
    ASSERT_TRUE(succeeded(result));
    size_t at = 0;
    for (const char* heading :
         {"\nUsage:", "\nScene:", "\nPicture:", "\nRenderer:", "\nOutput:", "\nDevice:", "\nDiagnostics:"}) {
        at = result.out.find(heading, at);
        ASSERT_NE(at, std::string::npos) << heading;
    }
    EXPECT_LT(result.out.find("\nPicture:"), result.out.find("--exposure"));
    EXPECT_LT(result.out.find("--exposure"), result.out.find("\nRenderer:"));
    std::istringstream lines(result.out.substr(0, result.out.find("Examples:")));
    for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 80u) << line;
    EXPECT_EQ(run({"help", "render"}, folder.path).out, result.out);
}

TEST(Help, KnowsTopics) {
    const TemporaryFolder folder;
    const auto text = [&](std::vector<std::string> words) {
        words.insert(words.begin(), "help");
        const Result result = run(words, folder.path);
        EXPECT_TRUE(succeeded(result)) << words.back();
        return result.out;
    };
    EXPECT_THAT(text({}), HasSubstr("environment variables"));
    EXPECT_THAT(text({"scenes"}), HasSubstr("city-glass"));
    EXPECT_THAT(text({"settings"}), HasSubstr("light-culling = "));
    EXPECT_THAT(text({"renderers"}), HasSubstr("z-prepass"));
    EXPECT_THAT(text({"environments"}), HasSubstr("studio"));
    EXPECT_THAT(text({"exit", "status"}), HasSubstr("Wrong usage"));
    EXPECT_EQ(text({"exit-status"}), text({"exit", "status"}));
    EXPECT_THAT(text({"environment-variables"}), HasSubstr("NO_COLOR"));
    EXPECT_EQ(text({"deferred"}), run({"renderers", "deferred"}, folder.path).out);
    EXPECT_THAT(text({"light-culling"}), HasSubstr("of light-prepass"));
    EXPECT_THAT(text({"ssao-radius"}), HasSubstr("needs ssao=half or full or --view ambient-occlusion"));
    EXPECT_THAT(text({"--exposure"}), HasSubstr("2^EV"));
    EXPECT_EQ(text({"exposure"}), text({"--exposure"}));
}

TEST(Style, IsForTerminalsThatWantIt) {
    EXPECT_TRUE(app::may_style(true, nullptr, "xterm"));
    EXPECT_TRUE(app::may_style(true, "", "xterm")) << "an empty NO_COLOR asks for nothing";
    EXPECT_FALSE(app::may_style(true, "1", "xterm"));
    EXPECT_FALSE(app::may_style(true, nullptr, "dumb"));
    EXPECT_FALSE(app::may_style(true, nullptr, nullptr));
    EXPECT_FALSE(app::may_style(false, nullptr, "xterm"));
}

TEST(Quiet, PrintsNothingOfWhatWasDone) {
    const TemporaryFolder folder;
    const Result result =
        run({"render", "spheres", "--size", "32x18", "--exposure", "auto", "--quiet", "-o", "a.png"}, folder.path);
    ASSERT_TRUE(succeeded(result));
    EXPECT_EQ(result.out + result.err, "");
    EXPECT_EQ(folder.entries(), 1u);
    EXPECT_EQ(run({"make", "spheres", "-o", "s.glb", "--quiet"}, folder.path).out, "");
    EXPECT_THAT(run({"make", "spheres", "-o", "missing/s.glb", "--quiet"}, folder.path).err, HasSubstr("missing"));
}

} // namespace
} // namespace prelight::test
