// `prelight view` in a real window, on a screen that nobody sees: tests/window/session.sh.
#include "process.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <sys/wait.h>

namespace prelight::test {
namespace {

TEST(ViewWindow, ShowsTheBytesThatItsRecordingGivesAndOutlivesLosses) {
    const Result without = run({"view", "spheres"}, ".", {}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}});
    EXPECT_TRUE(failed_with(without, 1)) << "without a screen";
    if (without.err.find("no window (it was made without") != std::string::npos)
        GTEST_SKIP() << "built without PRELIGHT_WINDOW";
    const std::string folder = PRELIGHT_BUILD_DIR "/window-session";
    const std::string command = PRELIGHT_SOURCE_DIR "/tests/window/session.sh " PRELIGHT_PROGRAM " " + folder + " >&2";
    const int status = std::system(command.c_str());
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == 77)
        GTEST_SKIP() << "Xvfb, xdotool or ImageMagick is missing (scripts/setup.sh --tests)";
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

} // namespace
} // namespace prelight::test
