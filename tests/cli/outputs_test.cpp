// What a run writes, and what it must not write over.
#include "files.hpp"
#include "process.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <prelight/image.hpp>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace prelight::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// A glTF whose buffer and picture lie beside it. It need not be drawn: outputs are checked before it is read.
void write_scene(const fs::path& folder) {
    write(folder / "scene.gltf",
          R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "data%20one.bin", "byteLength": 4}],
        "images": [{"uri": "wall.png"}], "extras": {"lights": [{"ies": "spot.ies"}]}})");
    for (const char* name : {"data one.bin", "wall.png", "spot.ies", "sky.hdr", "toon.glsl", "before.json"})
        write(folder / name, name);
}

/// Status 2, and every file of the folder as it was.
void expect_refused(const fs::path& folder, const std::vector<std::string>& arguments, const std::string& named) {
    SCOPED_TRACE(testing::PrintToString(arguments));
    std::map<fs::path, std::string> before;
    for (const auto& entry : fs::directory_iterator(folder))
        before[entry.path()] = bytes_of(entry.path());
    const Result result = run(arguments, folder);
    EXPECT_TRUE(failed_with(result, 2));
    EXPECT_THAT(result.err, HasSubstr(named));
    size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        ++count;
        EXPECT_EQ(before[entry.path()], bytes_of(entry.path())) << entry.path();
    }
    EXPECT_EQ(count, before.size());
}

TEST(Outputs, AnInputIsNeverOverwritten) {
    const TemporaryFolder folder;
    write_scene(folder.path);
    fs::create_symlink("scene.gltf", folder.path / "link.json");
    fs::create_hard_link(folder.path / "scene.gltf", folder.path / "hard.json");
    fs::create_symlink("data one.bin", folder.path / "bin.json");
    const auto stats = [&](const char* file) {
        return std::vector<std::string>{"render", "scene.gltf", "-o", "a.png", "--stats", file};
    };
    for (const char* file :
         {"scene.gltf", "./scene.gltf", "link.json", "hard.json", "data one.bin", "bin.json", "spot.ies"})
        expect_refused(folder.path, stats(file), file);
    expect_refused(folder.path, {"render", "scene.gltf", "-o", "wall.png"}, "wall.png");
    expect_refused(folder.path, {"render", "scene.gltf", "-o", "a.png", "--view", "depth=wall.png"}, "wall.png");
    expect_refused(folder.path, {"render", "spheres", "-o", "a.png", "--environment", "sky.hdr", "--stats", "sky.hdr"},
                   "sky.hdr");
    expect_refused(folder.path,
                   {"render", "spheres", "-o", "a.png", "--material", "floor=toon.glsl", "--stats", "toon.glsl"},
                   "toon.glsl");
    expect_refused(folder.path, {"bench", "scene.gltf", "--json", "data one.bin"}, "data one.bin");
    expect_refused(folder.path, {"bench", "spheres", "--baseline", "before.json", "--json", "before.json"},
                   "before.json");
    expect_refused(folder.path, {"bench", "encodings", "--scene", "scene.gltf", "--json", "hard.json"}, "hard.json");
    fs::create_symlink("before.json", folder.path / "page.html");
    expect_refused(folder.path, {"bench", "report", "before.json", "-o", "page.html"}, "page.html");
    expect_refused(folder.path, {"compare", "scene.gltf", "-o", "."}, "which this run reads");
}

TEST(Outputs, TwoOfThemAreNeverOneFile) {
    const TemporaryFolder folder;
    write(folder.path / "b.png", "b");
    fs::create_hard_link(folder.path / "b.png", folder.path / "hard.png");
    fs::create_symlink("new.png", folder.path / "to new.png");
    fs::create_directory_symlink(".", folder.path / "here");
    const auto both = [&](const char* output, const char* view) {
        expect_refused(folder.path, {"render", "spheres", "-o", output, "--view", std::string("depth=") + view},
                       "two outputs");
    };
    both("b.png", "hard.png");
    both("new.png", "to new.png");
    both("new.png", "here/new.png");
    both("new.png", "./new.png");
}

TEST(Outputs, ALinkStaysAndItsTargetIsWritten) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path / "pictures");
    fs::create_symlink("pictures/b.png", folder.path / "a.png"); // nothing is there yet
    for (int round = 0; round < 2; ++round) {
        ASSERT_TRUE(succeeded(
            run({"render", "spheres", "--renderer", "reference", "--size", "16x9", "-o", "a.png"}, folder.path)));
        EXPECT_TRUE(fs::is_symlink(folder.path / "a.png"));
        EXPECT_EQ(load_png(folder.path / "pictures/b.png").width, 16u);
        EXPECT_EQ(folder.entries(), 2u);
    }
    fs::create_symlink("circle.png", folder.path / "circle.png");
    EXPECT_TRUE(failed_with(run({"render", "spheres", "-o", "circle.png"}, folder.path), 1));
}

TEST(Outputs, NamesMayBeAsLongAsTheSystemHasThem) {
    const TemporaryFolder folder;
    const std::string longest = std::string(251, 'n') + ".png", longer = std::string(252, 'n') + ".png";
    ASSERT_TRUE(
        succeeded(run({"render", "spheres", "--renderer", "reference", "--size", "16x9", "-o", longest}, folder.path)));
    EXPECT_TRUE(fs::exists(folder.path / longest));
    const Result result = run({"render", "spheres", "-o", longer}, folder.path);
    EXPECT_TRUE(failed_with(result, 1));
    EXPECT_THAT(result.err, HasSubstr("File name too long"));
}

TEST(Outputs, ADeviceOrAPipeIsWrittenAndNotReplaced) {
    const TemporaryFolder folder;
    const std::vector<std::string> render{"render", "spheres", "--renderer", "reference", "--size",
                                          "16x9",   "-o",      "a.png",      "--stats"};
    const auto stats = [&](const std::string& file) {
        std::vector<std::string> arguments = render;
        arguments.push_back(file);
        return run(arguments, folder.path);
    };
    EXPECT_TRUE(succeeded(stats("/dev/null")));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    const Result full = stats("/dev/full");
    EXPECT_TRUE(failed_with(full, 1));
    EXPECT_THAT(full.err, HasSubstr("/dev/full: cannot be written (No space left on device)"));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
    ASSERT_EQ(mkfifo((folder.path / "pipe").c_str(), 0600), 0);
    const Result alone = stats("pipe");
    EXPECT_TRUE(failed_with(alone, 1));
    EXPECT_THAT(alone.err, HasSubstr("pipe: nobody reads this pipe"));
    std::string read;
    std::thread reader([&] { read = bytes_of(folder.path / "pipe"); });
    EXPECT_TRUE(succeeded(stats("pipe")));
    reader.join();
    EXPECT_THAT(read, HasSubstr("\"renderer\": \"reference\""));
    EXPECT_TRUE(fs::is_fifo(folder.path / "pipe"));
}

/// A program with a shell around it, which can set limits and close streams.
Result in_shell(const fs::path& folder, const std::string& before, const std::string& arguments,
                const std::string& after = "") {
    const std::string command = "cd '" + folder.string() + "' && " + before + " exec '" PRELIGHT_PROGRAM "' " +
                                arguments + " " + after + " 2> '" + folder.string() + "/said'";
    const int status = std::system(("exec bash -c \"" + command + "\"").c_str());
    Result result;
    result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    result.err = bytes_of(folder / "said");
    fs::remove(folder / "said");
    return result;
}

TEST(Outputs, ALimitOfFileSizesIsTold) {
    const TemporaryFolder folder;
    for (const char* command :
         {"make spheres -o a.glb", "render spheres --renderer reference --size 160x90 -o a.exr"}) {
        const Result result = in_shell(folder.path, "ulimit -f 8;", command); // KiB
        EXPECT_TRUE(failed_with(result, 1));
        EXPECT_THAT(result.err, AllOf(HasSubstr("prelight: a."), HasSubstr("(File too large)"), Not(HasSubstr("tmp"))));
        EXPECT_EQ(folder.entries(), 0u);
    }
}

TEST(Outputs, AClosedOrFullStandardOutputIsTold) {
    const TemporaryFolder folder;
    for (const char* where : {">&-", "> /dev/full"}) {
        const Result result = in_shell(folder.path, "", "materials", where);
        EXPECT_TRUE(failed_with(result, 1)) << where;
        EXPECT_THAT(result.err, HasSubstr("standard output: cannot be written ("));
    }
    // The reader is gone before anything is written.
    const Result piped = in_shell(folder.path, "exec > >(exec true); sleep 0.5;", "materials");
    EXPECT_TRUE(failed_with(piped, 1));
    EXPECT_THAT(piped.err, HasSubstr("standard output: cannot be written (Broken pipe)"));
    // A picture never takes the number of a stream that is closed.
    const Result closed = in_shell(folder.path, "", "make spheres --lights 1 -o a.glb", ">&-");
    EXPECT_TRUE(failed_with(closed, 1));
    EXPECT_EQ(bytes_of(folder.path / "a.glb").substr(0, 4), "glTF");
}

TEST(Outputs, AFullDiskLeavesNothing) {
    const TemporaryFolder folder;
    const std::string mount = "mount -t tmpfs -o size=8k none '" + folder.path.string() + "' 2> /dev/null";
    if (std::system(mount.c_str()) != 0)
        GTEST_SKIP() << "no small file system can be mounted here";
    for (const char* command : {"a.glb", "a.exr", "a.png"}) {
        const std::string name = command;
        const Result result =
            name == "a.glb"
                ? run({"make", "spheres", "-o", name}, folder.path)
                : run({"render", "spheres", "--renderer", "reference", "--size", "320x180", "-o", name}, folder.path);
        EXPECT_TRUE(failed_with(result, 1));
        EXPECT_THAT(result.err, HasSubstr(name + ": cannot be written (No space left on device)"));
        EXPECT_EQ(folder.entries(), 0u);
    }
    EXPECT_EQ(std::system(("umount '" + folder.path.string() + "'").c_str()), 0);
}

TEST(Outputs, AFolderThatCannotBeWrittenIsTold) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path / "locked");
    fs::permissions(folder.path / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    if (geteuid() == 0)
        GTEST_SKIP() << "root may write everywhere";
    const Result result = run({"render", "spheres", "-o", "locked/a.png"}, folder.path);
    EXPECT_TRUE(failed_with(result, 1));
    EXPECT_THAT(result.err, HasSubstr("locked/a.png: cannot be written (Permission denied)"));
}

TEST(Outputs, ANameForManyPicturesIsRefused) {
    const TemporaryFolder folder;
    for (const char* name : {"f-%03d.png", "f%d.png", "f.####.png", "f##.exr"}) {
        const Result result = run({"render", "spheres", "-o", name}, folder.path);
        EXPECT_TRUE(failed_with(result, 2)) << name;
        EXPECT_THAT(result.err, HasSubstr("names a series of pictures"));
    }
    EXPECT_TRUE(failed_with(run({"render", "spheres", "-o", "a.png", "--view", "depth=d-%d.png"}, folder.path), 2));
    EXPECT_TRUE(succeeded(
        run({"render", "spheres", "--renderer", "reference", "--size", "16x9", "-o", "100%.png"}, folder.path)));
    EXPECT_TRUE(succeeded(
        run({"render", "spheres", "--renderer", "reference", "--size", "16x9", "-o", "take #2.png"}, folder.path)));
}

TEST(Outputs, WrongNamesHaveOneStatusAndCostNoTime) {
    const TemporaryFolder folder;
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"render", "citty", "-o", "a.png"},
                                                      {"compare", "citty", "-o", "r"},
                                                      {"bench", "citty"},
                                                      {"bench", "encodings", "--scene", "citty"},
                                                      {"make", "citty", "-o", "a.glb"},
                                                      {"render", "city", "--renderer", "defered", "-o", "a.png"},
                                                      {"render", "city", "--view", "colour", "-o", "a.png"},
                                                      {"render", "city", "--set", "normals=oct33", "-o", "a.png"},
                                                      {"compare", "city", "--renderers", "defered", "-o", "r"}}) {
        const Result result = run(arguments, folder.path);
        EXPECT_TRUE(failed_with(result, 2)) << testing::PrintToString(arguments);
        EXPECT_EQ(folder.entries(), 0u);
    }
}

} // namespace
} // namespace prelight::test
