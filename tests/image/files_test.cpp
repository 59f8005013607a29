#include "temporary_folder.hpp"
#include <bit>
#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <limits>
#include <platform/atomic_file.hpp>
#include <prelight/error.hpp>
#include <prelight/image.hpp>

namespace prelight {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// The message of the Error that `action` throws.
template <typename Action>
std::string message_of(Action action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing was thrown";
}

void write_text(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

std::string read_text(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(AtomicFile, AppearsOnlyWithCommit) {
    const TemporaryFolder folder;
    const auto target = folder.path / "a.txt";
    write_text(target, "old");
    {
        AtomicFile file(target);
        file.write("new", 3);
        EXPECT_EQ(read_text(target), "old");
        EXPECT_EQ(file.temporary().parent_path(), folder.path);
        EXPECT_EQ(read_text(file.temporary()), "new");
        file.commit();
        EXPECT_EQ(read_text(target), "new");
    }
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(AtomicFile, LeavesNothingWithoutCommit) {
    const TemporaryFolder folder;
    {
        AtomicFile file(folder.path / "a.txt");
        file.write("new", 3);
    }
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(AtomicFile, TwoWritersOfOneTargetDoNotMeet) {
    const TemporaryFolder folder;
    AtomicFile first(folder.path / "a.txt"), second(folder.path / "a.txt");
    EXPECT_NE(first.temporary(), second.temporary());
}

TEST(AtomicFile, NamesTheFileAndTheReason) {
    const TemporaryFolder folder;
    const auto in_missing = folder.path / "missing" / "a.png";
    const std::string message = message_of([&] { AtomicFile file(in_missing); });
    EXPECT_EQ(message, in_missing.string() + ": folder " + (folder.path / "missing").string() + " does not exist");
    EXPECT_THAT(message_of([&] { AtomicFile file(folder.path); }), HasSubstr("is a folder"));
    EXPECT_THAT(message_of([&] { AtomicFile file(folder.path / ""); }), HasSubstr("not the name"));
    write_text(folder.path / "plain", "");
    EXPECT_THAT(message_of([&] { AtomicFile file(folder.path / "plain" / "a.png"); }), HasSubstr("is not a folder"));
}

TEST(Png, KeepsBytesAndRoundsToNearest) {
    const TemporaryFolder folder;
    Image image(3, 2);
    image.at(0, 0) = {0, 1, 100 / 255.0f};
    image.at(1, 0) = {-1, 2, 100.4f / 255};
    image.at(2, 0) = {std::numeric_limits<float>::quiet_NaN(), 100.6f / 255, 0.5f};
    image.at(2, 1) = {7 / 255.0f, 8 / 255.0f, 9 / 255.0f};
    save_png(image, folder.path / "a.png");
    const Image back = load_png(folder.path / "a.png");
    ASSERT_EQ(back.width, 3u);
    ASSERT_EQ(back.height, 2u);
    const auto bytes = [&](uint32_t x, uint32_t y) { return back.at(x, y) * 255.0f; };
    EXPECT_EQ(bytes(0, 0), glm::vec3(0, 255, 100));
    EXPECT_EQ(bytes(1, 0), glm::vec3(0, 255, 100));
    EXPECT_EQ(bytes(2, 0), glm::vec3(0, 101, 128));
    EXPECT_EQ(bytes(2, 1), glm::vec3(7, 8, 9));
    EXPECT_EQ(bytes(0, 1), glm::vec3(0));
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Exr, KeepsHalvesAndClamps) {
    const TemporaryFolder folder;
    Image image(5, 3);
    image.at(0, 0) = {1e6f, -1e6f, std::numeric_limits<float>::infinity()};
    image.at(4, 2) = {0.1f, 1000.3f, 6e-8f};
    image.at(1, 2) = {-2.5f, 0, 1};
    save_exr(image, folder.path / "a.exr");
    const Image back = load_exr(folder.path / "a.exr");
    ASSERT_EQ(back.width, 5u);
    ASSERT_EQ(back.height, 3u);
    EXPECT_EQ(back.at(0, 0), glm::vec3(65504, -65504, 65504));
    // A half has 11 significant bits: the rounding error is at most 2^-11 of the value.
    EXPECT_NEAR(back.at(4, 2).x, 0.1f, 0.1f / 2048);
    EXPECT_NEAR(back.at(4, 2).y, 1000.3f, 1000.3f / 2048);
    EXPECT_NEAR(back.at(4, 2).z, 6e-8f, 1e-9f); // the smallest subnormal
    EXPECT_EQ(back.at(1, 2), glm::vec3(-2.5f, 0, 1));
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Files, SameBytesTwice) {
    const TemporaryFolder folder;
    Image image(64, 48);
    for (size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = glm::vec3(static_cast<float>(i % 97) / 97);
    for (const char* name : {"a", "b"}) {
        save_png(image, folder.path / (std::string(name) + ".png"));
        save_exr(image, folder.path / (std::string(name) + ".exr"));
    }
    EXPECT_EQ(read_text(folder.path / "a.png"), read_text(folder.path / "b.png"));
    EXPECT_EQ(read_text(folder.path / "a.exr"), read_text(folder.path / "b.exr"));
}

TEST(Files, ErrorsNameTheFileAndLeaveNothing) {
    const TemporaryFolder folder;
    const Image image(4, 4), empty;
    const auto path = [&](const char* name) { return folder.path / name; };
    for (const char* name : {"missing/a.png", "missing/a.exr"})
        EXPECT_THAT(message_of([&] {
                        std::string_view(name).ends_with("png") ? save_png(image, path(name))
                                                                : save_exr(image, path(name));
                    }),
                    HasSubstr("does not exist"));
    EXPECT_THAT(message_of([&] { save_png(empty, path("a.png")); }), HasSubstr("0x0 pixels"));
    EXPECT_THAT(message_of([&] { save_exr(empty, path("a.exr")); }), HasSubstr("0x0 pixels"));
    EXPECT_EQ(folder.entries(), 0u);

    save_png(image, path("whole.png"));
    save_exr(image, path("whole.exr"));
    for (const char* name : {"whole.png", "whole.exr"}) {
        const std::string bytes = read_text(path(name));
        write_text(path("cut"), bytes.substr(0, bytes.size() / 2));
        const bool png = std::string_view(name).ends_with("png");
        const auto load = [&](const char* file) {
            return message_of([&] { png ? load_png(path(file)) : load_exr(path(file)); });
        };
        EXPECT_THAT(load("cut"), StartsWith(path("cut").string() + ": not a readable "));
        EXPECT_THAT(load("absent"), StartsWith(path("absent").string() + ": cannot be opened"));
        write_text(path("text"), "hello");
        EXPECT_THAT(load("text"), HasSubstr("not a readable"));
    }
}

} // namespace
} // namespace prelight
