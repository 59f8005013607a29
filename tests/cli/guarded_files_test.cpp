// Whatever a name on the command line leads to, the run ends at once with one line.
#include "process.hpp"

#include <fmt/format.h>
#include <fstream>
#include <gmock/gmock.h>
#include <prelight/image.hpp>
#include <sys/stat.h>

namespace prelight::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// One option of one command that reads a file.
struct Reader {
    const char* name;
    std::vector<std::string> arguments; ///< FILE stands for the file
    std::string ending;                 ///< that its file must have
};

std::vector<Reader> readers() {
    const std::vector<std::string> small{"--renderer", "reference", "--size", "16x16"};
    const auto render = [&](const std::vector<std::string>& arguments) {
        return joined(joined({"render"}, arguments), small);
    };
    return {
        {"scene", render({"FILE", "-o", "a.png"}), ".glb"},
        {"environment hdr", render({"spheres", "-o", "a.png", "--environment", "FILE"}), ".hdr"},
        {"environment exr", render({"spheres", "-o", "a.png", "--environment", "FILE"}), ".exr"},
        {"environment png", render({"spheres", "-o", "a.png", "--environment", "FILE"}), ".png"},
        {"material", render({"spheres", "-o", "a.png", "--material", "floor=FILE"}), ".glsl"},
        {"baseline", {"bench", "spheres", "--baseline", "FILE"}, ".json"},
        {"figures", {"bench", "report", "FILE", "-o", "page.html"}, ".json"},
    };
}

/// Runs every reader on `folder`/FILE and expects one line that names it and says `why`.
void expect_every_reader_refuses(const TemporaryFolder& folder, const std::string& file, const std::string& why) {
    for (const Reader& reader : readers()) {
        const std::string name = "it" + reader.ending;
        fs::remove(folder.path / name);
        fs::create_symlink(file, folder.path / name);
        std::vector<std::string> arguments = reader.arguments;
        for (std::string& argument : arguments)
            if (const size_t at = argument.find("FILE"); at != std::string::npos)
                argument.replace(at, 4, name);
        const Result result = run(arguments, folder.path, {.seconds = 30});
        SCOPED_TRACE(std::string(reader.name) + ": " + file);
        EXPECT_TRUE(failed_with(result, 1));
        EXPECT_THAT(result.err, HasSubstr(name));
        EXPECT_THAT(result.err, HasSubstr(why));
        EXPECT_FALSE(fs::exists(folder.path / "a.png"));
        EXPECT_LT(result.peak_bytes, uint64_t(address_sanitizer ? 4096 : 512) << 20);
        fs::remove(folder.path / name);
    }
}

TEST(GuardedFiles, PipesDevicesFoldersAndLoops) {
    const TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder.path / "pipe").c_str(), 0600), 0);
    fs::create_directory(folder.path / "inner");
    fs::create_symlink("round", folder.path / "round");
    expect_every_reader_refuses(folder, "pipe", "is a pipe, not a file");
    expect_every_reader_refuses(folder, "/dev/zero", "is a device, not a file");
    expect_every_reader_refuses(folder, "inner", "is a folder, not a file");
    expect_every_reader_refuses(folder, "round", "Too many levels of symbolic links");
    expect_every_reader_refuses(folder, "nothing", "No such file or directory");
}

TEST(GuardedFiles, EmptyAndHugeOnes) {
    const TemporaryFolder folder;
    std::ofstream(folder.path / "empty");
    std::ofstream(folder.path / "huge");
    fs::resize_file(folder.path / "huge", uint64_t(1) << 42); // takes no room on the disk
    expect_every_reader_refuses(folder, "huge", "is too large");
    for (const Reader& reader : readers()) {
        if (std::string(reader.name) == "material")
            continue; // an empty one is for the compiler to judge
        std::vector<std::string> arguments = reader.arguments;
        const std::string name = "it" + reader.ending;
        fs::copy_file(folder.path / "empty", folder.path / name, fs::copy_options::overwrite_existing);
        for (std::string& argument : arguments)
            if (argument == "FILE")
                argument = name;
        const Result result = run(arguments, folder.path, {.seconds = 30});
        EXPECT_TRUE(failed_with(result, 1)) << reader.name;
        EXPECT_THAT(result.err, HasSubstr(name));
    }
}

TEST(GuardedFiles, ThoseThatASceneNames) {
    const TemporaryFolder folder;
    const auto scene = [&](const std::string& uri) {
        std::ofstream(folder.path / "scene.gltf")
            << R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":")" << uri << R"("}]})";
        return run({"render", "scene.gltf", "-o", "a.png", "--renderer", "reference"}, folder.path, {.seconds = 30});
    };
    ASSERT_EQ(mkfifo((folder.path / "pipe").c_str(), 0600), 0);
    std::ofstream(folder.path / "huge");
    fs::resize_file(folder.path / "huge", uint64_t(1) << 42);
    fs::create_symlink("round", folder.path / "round");
    for (const auto& [uri, why] :
         {std::pair("pipe", "does not name a file"), {"huge", "is too large"}, {"round", "Too many levels"}}) {
        const Result result = scene(uri);
        EXPECT_TRUE(failed_with(result, 1)) << uri;
        EXPECT_THAT(result.err, HasSubstr("scene.gltf: buffer 0: "));
        EXPECT_THAT(result.err, HasSubstr(fmt::format("\"{}\"", uri)));
        EXPECT_THAT(result.err, HasSubstr(why));
    }
}

TEST(MemoryLimit, TakesBytesAndLetters) {
    const TemporaryFolder folder;
    const auto limited = [&](const char* size) {
        return run(
            {"render", "spheres", "-o", "a.png", "--renderer", "reference", "--size", "8x8", "--memory-limit", size},
            folder.path);
    };
    for (const char* size : {"1000000000", "900M", "2g", "1T", "5000000K"})
        EXPECT_TRUE(succeeded(limited(size))) << size;
    for (const char* size : {"0", "-1", "1.5G", "G", "M5", "99999999999T", "12 M", "x"}) {
        const Result result = limited(size);
        EXPECT_TRUE(failed_with(result, 2)) << size;
        EXPECT_THAT(result.err, HasSubstr("--memory-limit"));
    }
}

/// A valid picture unpacks to far more than it has bytes; it opens, scaled down where memory is short.
TEST(MemoryLimit, LargeTexturesOpenAndAreScaledDownToIt) {
    const fs::path scene = fs::path(PRELIGHT_SHARED_SCENES) / "../cases/tex_8192_png.glb";
    if (!fs::exists(scene))
        GTEST_SKIP() << "the shared cases are not on this machine";
    const TemporaryFolder folder;
    for (const std::vector<std::string>& limit : {std::vector<std::string>{}, {"--memory-limit", "512M"}}) {
        const std::vector<std::string> albedo{"render", scene.string(), "-o",     "a.png",      "--size",
                                              "16x16",  "--view",       "albedo", "--renderer", "reference"};
        const Result result = run(joined(albedo, limit), folder.path);
        EXPECT_TRUE(succeeded(result));
        EXPECT_EQ(load_png(folder.path / "a.png").at(8, 8) * 255.0f, glm::vec3(200, 60, 60));
        const bool scaled = result.err.find("scaled down from 8192 × 8192 to 4096 × 4096 pixels") != std::string::npos;
        EXPECT_EQ(scaled, !limit.empty()) << result.err;
    }
}

} // namespace
} // namespace prelight::test
