// Programs of examples/ that embed the library, run as they are.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <image/temporary_folder.hpp>
#include <prelight/image.hpp>
#include <sstream>
#include <sys/wait.h>

namespace prelight {
namespace {

namespace fs = std::filesystem;

class Example : public testing::Test {
protected:
    fs::path folder() const { return folder_.path; }
    static fs::path program(const std::string& name) {
        return fs::path(PRELIGHT_BUILD_DIR "/examples/example_" + name);
    }

    /// Runs it in the folder, under validation where it can; it succeeds and says nothing.
    void run(const std::string& name, const std::string& arguments = "", const std::string& before = "") const {
        const std::string log = (folder() / "log").string();
        const std::string command = "cd '" + folder().string() +
                                    "' && env EXAMPLE_VALIDATE=1 VK_LAYER_VALIDATE_SYNC=1 "
                                    "VK_LAYER_PATH=" PRELIGHT_BUILD_DIR "/share/prelight/layers timeout 120 " +
                                    before + " '" + program(name).string() + "' " + arguments + " >'" + log + "' 2>&1";
        const int status = std::system(command.c_str());
        std::stringstream said;
        said << std::ifstream(log).rdbuf();
        ASSERT_TRUE(WIFEXITED(status));
        EXPECT_EQ(WEXITSTATUS(status), 0) << said.str();
        EXPECT_EQ(said.str(), "");
    }

private:
    TemporaryFolder folder_;
};

float mean_light_of(const Image& picture) {
    float sum = 0;
    for (const glm::vec3& pixel : picture.pixels)
        sum += (pixel.r + pixel.g + pixel.b) / 3;
    return sum / float(picture.pixels.size());
}

TEST_F(Example, HelloPicture) {
    run("hello_picture");
    const Image picture = load_png(folder() / "hello.png");
    EXPECT_EQ(picture.width, 640u);
    EXPECT_GT(mean_light_of(picture), 0.05f);
}

TEST_F(Example, OwnPassDrawsItsLines) {
    run("own_pass", "lines.png");
    const Image picture = load_png(folder() / "lines.png");
    const auto lines = std::ranges::count_if(picture.pixels, [](const glm::vec3& pixel) {
        return pixel.r == 1 && std::abs(pixel.g - 0.8f) < 0.003f && std::abs(pixel.b - 0.1f) < 0.003f;
    });
    EXPECT_GT(lines, 500);
    EXPECT_LT(lines, 640 * 360 / 4) << "and the picture is there too";
}

TEST_F(Example, CameraQueueDeliversEachPicture) {
    run("camera_queue", ". 3");
    const Image first = load_png(folder() / "camera-0.png"), last = load_png(folder() / "camera-2.png");
    EXPECT_FALSE(first.pixels == last.pixels);
    EXPECT_GT(mean_light_of(first), 0.05f);
    EXPECT_FALSE(fs::exists(folder() / "camera-3.png"));
}

class ExampleInAWindow : public Example {
protected:
    void SetUp() override {
        if (!fs::exists(program("own_device")))
            GTEST_SKIP() << "built without GLFW";
        if (std::system("command -v xvfb-run xauth >/dev/null 2>&1") != 0)
            GTEST_SKIP() << "xvfb-run is not installed (scripts/setup.sh --tests)";
    }
    void run_in_window(const std::string& name, const std::string& arguments) const {
        run(name, arguments, "xvfb-run --auto-servernum --server-args='-screen 0 800x600x24'");
    }
};

TEST_F(ExampleInAWindow, OnItsOwnDevice) { run_in_window("own_device", "12"); }
TEST_F(ExampleInAWindow, WithAThousandLights) { run_in_window("window_lights", "12"); }

TEST_F(ExampleInAWindow, WithAThousandLightsTakesThirtyLines) {
    std::ifstream source(PRELIGHT_SOURCE_DIR "/examples/window_lights/main.cpp");
    int lines = 0;
    for (std::string line; std::getline(source, line); ++lines)
        EXPECT_LE(line.size(), 120u);
    EXPECT_GT(lines, 0);
    EXPECT_LE(lines, 30);
}

TEST_F(ExampleInAWindow, NeedsADisplay) {
    const std::string said = (folder() / "said").string();
    const std::string command =
        "env -u DISPLAY -u WAYLAND_DISPLAY '" + program("window_lights").string() + "' 1 >'" + said + "' 2>&1";
    EXPECT_NE(std::system(command.c_str()), 0);
    std::stringstream text;
    text << std::ifstream(said).rdbuf();
    EXPECT_NE(text.str().find("what():  GLFW: "), std::string::npos) << text.str();
}

} // namespace
} // namespace prelight
