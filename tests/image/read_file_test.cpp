// Every file of a user's or a stranger's is read in one way, which ends for whatever the name leads to.
#include "temporary_folder.hpp"
#include <atomic>
#include <chrono>
#include <cstring>
#include <fstream>
#include <gmock/gmock.h>
#include <platform/read_file.hpp>
#include <platform/spare_memory.hpp>
#include <prelight/error.hpp>
#include <prelight/image.hpp>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <thread>

namespace prelight {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
namespace fs = std::filesystem;

std::string reason_of(const fs::path& file, uint64_t largest = 1000) {
    try {
        read_bytes(file, largest);
    } catch (const FileError& error) {
        return error.what();
    }
    return "none";
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

TEST(ReadFile, WholeFilesWithPadding) {
    const TemporaryFolder folder;
    const fs::path file = folder.path / "a";
    std::string text(300'000, 'x');
    text.back() = 'y';
    write(file, text);
    const auto bytes = read_bytes(file, 300'000, 64);
    ASSERT_EQ(bytes.size(), 300'064u);
    EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + 300'000), text);
    EXPECT_EQ(std::vector<uint8_t>(bytes.end() - 64, bytes.end()), std::vector<uint8_t>(64));
    EXPECT_EQ(read_text_file(file, 300'000), text);
    write(file, "");
    EXPECT_TRUE(read_bytes(file, 0).empty());
    EXPECT_EQ(read_bytes(file, 0, 3), FileBytes(3, uint8_t(0)));
    fs::create_symlink("a", folder.path / "link");
    EXPECT_EQ(reason_of(folder.path / "link"), "none");
}

TEST(ReadFile, WhatIsNoFileIsRefusedBeforeItIsRead) {
    const TemporaryFolder folder;
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_EQ(mkfifo((folder.path / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(reason_of(folder.path / "pipe"), "is a pipe, not a file");
    for (const char* device : {"/dev/zero", "/dev/random", "/dev/full", "/dev/tty", "/dev/null"})
        if (fs::exists(device)) {
            EXPECT_EQ(reason_of(device), "is a device, not a file") << device;
        }
    EXPECT_EQ(reason_of(folder.path), "is a folder, not a file");
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un address{AF_UNIX, {}};
    std::strncpy(address.sun_path, (folder.path / "socket").c_str(), sizeof address.sun_path - 1);
    ASSERT_EQ(bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(reason_of(folder.path / "socket"), "is a socket, not a file");
    close(socket);
    fs::create_symlink("/dev/zero", folder.path / "link");
    EXPECT_EQ(reason_of(folder.path / "link"), "is a device, not a file");
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST(ReadFile, TheSystemsReasonIsTold) {
    const TemporaryFolder folder;
    EXPECT_EQ(reason_of(folder.path / "none"), "cannot be opened (No such file or directory)");
    fs::create_symlink("loop", folder.path / "loop");
    EXPECT_EQ(reason_of(folder.path / "loop"), "cannot be opened (Too many levels of symbolic links)");
    EXPECT_EQ(reason_of(folder.path / std::string(300, 'n')), "cannot be opened (File name too long)");
    write(folder.path / "plain", "x");
    EXPECT_EQ(reason_of(folder.path / "plain" / "x"), "cannot be opened (Not a directory)");
    if (fs::exists("/proc/self/mem")) { // a file, and nothing lies at its beginning
        EXPECT_EQ(reason_of("/proc/self/mem"), "cannot be read (Input/output error)");
    }
    chmod((folder.path / "plain").c_str(), 0);
    if (geteuid() == 0) { // root may read everything: ask as somebody else, in a process of its own
        chmod(folder.path.c_str(), 0755);
        const pid_t child = fork();
        if (child == 0)
            _exit(setuid(65534) == 0 && reason_of(folder.path / "plain") == "cannot be opened (Permission denied)" ? 0
                                                                                                                   : 1);
        int status = -1;
        waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    } else {
        EXPECT_EQ(reason_of(folder.path / "plain"), "cannot be opened (Permission denied)");
    }
    try {
        read_file(folder.path / "none", 1);
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), (folder.path / "none").string() + ": cannot be opened (No such file or directory)");
    }
}

TEST(ReadFile, SizesBeyondTheLimitAreRefused) {
    const TemporaryFolder folder;
    write(folder.path / "a", std::string(1001, 'x'));
    EXPECT_EQ(reason_of(folder.path / "a", 1001), "none");
    EXPECT_EQ(reason_of(folder.path / "a", 1000), "is too large: at most 1000 bytes of such a file are read");
    write(folder.path / "sparse", "");
    fs::resize_file(folder.path / "sparse", uint64_t(1) << 42); // takes no room on the disk
    EXPECT_THAT(reason_of(folder.path / "sparse", largest_file::scene), HasSubstr("is too large"));
    if (fs::exists("/proc/self/status")) { // claims to be empty
        EXPECT_GT(read_bytes("/proc/self/status", 1 << 20).size(), 100u);
        EXPECT_THAT(reason_of("/proc/self/status", 10), HasSubstr("is too large"));
    }
}

TEST(ReadFile, AFileThatGrowsOrShrinksMeanwhileEnds) {
    const TemporaryFolder folder;
    const fs::path file = folder.path / "log";
    write(file, "x");
    std::atomic<bool> stop = false;
    std::atomic<int> rounds = 0;
    std::thread writer([&] {
        const std::string block(1 << 16, 'x');
        std::ofstream stream(file, std::ios::binary | std::ios::app);
        for (int i = 0; !stop; ++i) {
            stream.write(block.data(), static_cast<std::streamsize>(block.size())).flush();
            if (i % 64 == 0)
                fs::resize_file(file, 1);
            rounds = i;
        }
    });
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < 50 || rounds < 500; ++i) {
        const std::string reason = reason_of(file, 4 << 20);
        EXPECT_TRUE(reason == "none" || reason.find("too large") != std::string::npos) << reason;
    }
    stop = true;
    writer.join();
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30));
}

TEST(ReadFile, PicturesAreReadThatWay) {
    const TemporaryFolder folder;
    const fs::path pipe = folder.path / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    for (const auto load : {load_hdr, load_exr, load_png})
        for (const fs::path& file : {pipe, fs::path("/dev/zero"), folder.path})
            try {
                load(file);
                ADD_FAILURE() << file;
            } catch (const Error& error) {
                EXPECT_THAT(error.what(), EndsWith(", not a file"));
                EXPECT_THAT(error.what(), testing::StartsWith(file.string() + ": is a "));
            }
}

TEST(SpareMemory, FollowsTheLimitsOfTheProcess) {
    EXPECT_GT(spare_memory(), uint64_t(1) << 20);
    EXPECT_LT(spare_memory(), uint64_t(1) << 50);
    const pid_t child = fork();
    if (child == 0) {
        const uint64_t before = spare_memory();
        const rlimit limit{uint64_t(256) << 20, RLIM_INFINITY};
        const bool set = setrlimit(RLIMIT_AS, &limit) == 0;
        _exit(set && before > 0 && spare_memory() <= uint64_t(256) << 20 ? 0 : 1);
    }
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
}

} // namespace
} // namespace prelight
