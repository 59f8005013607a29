// Which device is taken: the ranking on made-up machines, and the real list.
#include "devices.hpp"
#include <algorithm>
#include <gmock/gmock.h>

namespace prelight {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

struct Made {
    const char* name;
    const char* type;
    bool usable = true;
};

std::vector<gpu::Candidate> machine(std::vector<Made> devices) {
    std::vector<gpu::Candidate> all;
    for (const Made& made : devices) {
        gpu::Candidate candidate;
        candidate.info.index = static_cast<uint32_t>(all.size());
        candidate.info.name = made.name;
        candidate.info.type = made.type;
        candidate.info.usable = made.usable;
        candidate.info.why_not = made.usable ? "" : "Vulkan 1.1, and 1.3 is needed";
        all.push_back(candidate);
    }
    return all;
}

/// Name of the only marked one.
std::string taken(const std::vector<gpu::Candidate>& all, const std::string& select) {
    std::string name;
    for (const gpu::Candidate& c : gpu::choose(all, select)) {
        EXPECT_EQ(c.info.chosen, !c.info.why_chosen.empty());
        if (c.info.chosen) {
            EXPECT_TRUE(name.empty()) << "two are marked";
            name = c.info.name;
        }
    }
    return name;
}

TEST(DeviceRanking, AutoPrefersDiscreteThenIntegratedThenVirtualThenSoftware) {
    std::vector<Made> all{{"strange", "other"},    {"soft", "software"}, {"virt", "virtual"},
                          {"intel", "integrated"}, {"big", "discrete"},  {"big2", "discrete"}};
    for (const char* expected : {"big", "big2", "intel", "virt", "soft", "strange"}) {
        EXPECT_EQ(taken(machine(all), "auto"), expected);
        std::erase_if(all, [&](const Made& m) { return m.name == std::string(expected); });
    }
}

TEST(DeviceRanking, AutoPassesOverWhatCannotBeUsed) {
    EXPECT_EQ(taken(machine({{"old", "discrete", false}, {"soft", "software"}}), "auto"), "soft");
}

TEST(DeviceRanking, AutoWithoutAUsableDeviceSaysWhy) {
    EXPECT_THAT([] { gpu::choose({}, "auto"); }, ThrowsMessage<Error>(HasSubstr("no device")));
    EXPECT_THAT(
        [] {
            gpu::choose(machine({{"old", "discrete", false}}), "auto");
        },
        ThrowsMessage<Error>(testing::AllOf(HasSubstr("old"), HasSubstr("1.3 is needed"))));
}

TEST(DeviceRanking, CpuIsTheFirstUsableSoftwareDevice) {
    const auto all = machine({{"big", "discrete"}, {"older", "software", false}, {"soft", "software"}});
    EXPECT_EQ(taken(all, "cpu"), "soft");
    EXPECT_THROW(gpu::choose(machine({{"big", "discrete"}}), "cpu"), UsageError);
}

TEST(DeviceRanking, ByIndexAndByPartOfTheName) {
    const auto all = machine({{"Radeon 7", "discrete"}, {"GeForce 9", "discrete"}, {"llvmpipe", "software"}});
    EXPECT_EQ(taken(all, "0"), "Radeon 7");
    EXPECT_EQ(taken(all, "1"), "GeForce 9");
    EXPECT_EQ(taken(all, "Force"), "GeForce 9");
    EXPECT_EQ(taken(all, "llvmpipe"), "llvmpipe");
    for (const char* wrong : {"3", "7", "99999999999999999999", "-1", "Voodoo", ""})
        EXPECT_THROW(gpu::choose(all, wrong), UsageError) << wrong;
}

TEST(DeviceRanking, ANamedDeviceThatCannotBeUsedIsAnErrorThatSaysWhy) {
    const auto all = machine({{"old", "discrete", false}, {"soft", "software"}});
    for (const char* select : {"0", "old"})
        EXPECT_THAT([&] { gpu::choose(all, select); }, ThrowsMessage<Error>(HasSubstr("1.3 is needed")));
}

void expect_list_and_selection_agree(const std::vector<DeviceInfo>& all) {
    ASSERT_FALSE(all.empty());
    EXPECT_EQ(std::count_if(all.begin(), all.end(), [](const DeviceInfo& d) { return d.chosen; }), 1);
    for (size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(all[i].index, i);
        EXPECT_FALSE(all[i].name.empty());
        EXPECT_FALSE(all[i].driver.empty());
        EXPECT_EQ(all[i].usable, all[i].why_not.empty());
        if (all[i].chosen) {
            EXPECT_EQ(Device::create({.select = "auto"})->name(), all[i].name);
        }
        if (!all[i].usable)
            continue;
        EXPECT_EQ(Device::create({.select = std::to_string(i)})->name(), all[i].name);
        EXPECT_EQ(Device::create({.select = all[i].name.substr(1, 6)})->name(), all[i].name);
    }
}

TEST(DeviceList, MarksWhatAutoTakesAndNamesWhatCanBeTaken) {
    expect_list_and_selection_agree(Device::list());
    EXPECT_THROW(Device::create({.select = "no such device"}), UsageError);
}

TEST(DeviceList, WithASecondDriver) {
    if (!swiftshader_installed())
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium has it)";
    const size_t before = Device::list().size();
    const ScopedVariable more("VK_ADD_DRIVER_FILES", swiftshader_driver_file);
    const std::vector<DeviceInfo> all = Device::list();
    EXPECT_EQ(all.size(), before + 1);
    expect_list_and_selection_agree(all);
    EXPECT_THAT(Device::create({.select = "SwiftShader"})->name(), HasSubstr("SwiftShader"));
}

TEST(DeviceList, WithoutADriverThereIsOneClearError) {
    const ScopedVariable none("VK_DRIVER_FILES", "/nonexistent.json");
    EXPECT_THROW(Device::create({}), Error);
}

} // namespace
} // namespace prelight
