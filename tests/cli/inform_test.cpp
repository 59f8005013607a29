// Commands that only tell something.
#include "process.hpp"

#include <gmock/gmock.h>
#include <prelight/device.hpp>
#include <prelight/renderer.hpp>

namespace prelight::test {
namespace {

using testing::HasSubstr;

TEST(Inform, HelpNamesEveryCommandAndHasExamples) {
    const TemporaryFolder folder;
    const Result result = run({"--help"}, folder.path);
    ASSERT_TRUE(succeeded(result));
    for (const char* command : {"render", "compare", "make", "devices", "renderers", "materials", "bench", "Examples:"})
        EXPECT_THAT(result.out, HasSubstr(command));
}

TEST(Inform, RenderHelpNamesEveryOption) {
    const TemporaryFolder folder;
    const Result result = run({"render", "--help"}, folder.path);
    ASSERT_TRUE(succeeded(result));
    for (const char* option :
         {"--renderer", "--preset", "--set",         "--size",     "--camera",  "--frames",   "--lights",
          "--seed",     "--watch",  "--view",        "--msaa",     "--shading", "--device",   "--tonemap",
          "--exposure", "--stats",  "--count-pairs", "--validate", "-o",        "--material", "Examples:"})
        EXPECT_THAT(result.out, HasSubstr(option));
}

TEST(Inform, CompareHelpNamesEveryOption) {
    const TemporaryFolder folder;
    const Result result = run({"compare", "--help"}, folder.path);
    ASSERT_TRUE(succeeded(result));
    for (const char* option :
         {"--renderers", "--light-counts", "--frame-limit", "--frames", "--size", "--camera", "--time", "--animation",
          "--lights", "--seed", "--shading", "--exposure", "--device", "--validate", "-o", "Examples:"})
        EXPECT_THAT(result.out, HasSubstr(option));
}

TEST(Inform, DevicesMarksExactlyOneAsTaken) {
    const TemporaryFolder folder;
    const Result result = run({"devices"}, folder.path);
    ASSERT_TRUE(succeeded(result));
    size_t marked = 0;
    for (size_t at = result.out.find("* "); at != std::string::npos; at = result.out.find("* ", at + 1))
        marked += at == 0 || result.out[at - 1] == '\n';
    EXPECT_EQ(marked, 2u) << "one device and the legend\n" << result.out;
    for (const DeviceInfo& device : Device::list()) {
        EXPECT_THAT(result.out, HasSubstr(device.name));
        EXPECT_THAT(result.out, HasSubstr(device.why_chosen));
    }
}

TEST(Inform, WithoutADriverDevicesAndRenderFailInOneLine) {
    const TemporaryFolder folder;
    const std::map<std::string, std::string> nothing = {{"VK_DRIVER_FILES", "/nonexistent.json"},
                                                        {"VK_ICD_FILENAMES", "/nonexistent.json"}};
    EXPECT_TRUE(failed_with(run({"devices"}, folder.path, {}, nothing), 1));
    EXPECT_TRUE(failed_with(run({"render", "spheres", "-o", "a.png", "--size", "64x36"}, folder.path, {}, nothing), 1));
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(Inform, RenderersListsEachInOneLine) {
    const TemporaryFolder folder;
    const Result result = run({"renderers"}, folder.path);
    ASSERT_TRUE(succeeded(result));
    const std::vector<RendererInfo> infos = renderer_infos();
    ASSERT_GE(infos.size(), 2u);
    EXPECT_EQ(size_t(std::ranges::count(result.out, '\n')), infos.size());
    for (const RendererInfo& info : infos)
        EXPECT_THAT(result.out, HasSubstr(info.name));
}

TEST(Inform, RenderersShowsEverythingOfOne) {
    const TemporaryFolder folder;
    for (const RendererInfo& info : renderer_infos()) {
        const Result result = run({"renderers", info.name}, folder.path);
        ASSERT_TRUE(succeeded(result));
        for (const SettingInfo& setting : info.settings) {
            EXPECT_THAT(result.out, HasSubstr(setting.key));
            EXPECT_THAT(result.out, HasSubstr("default " + setting.default_value));
            for (const std::string& value : setting.values)
                EXPECT_THAT(result.out, HasSubstr(value));
        }
        for (const std::string& view : info.views)
            EXPECT_THAT(result.out, HasSubstr(view));
        for (const std::string& preset : info.presets)
            EXPECT_THAT(result.out, HasSubstr(preset));
    }
}

} // namespace
} // namespace prelight::test
