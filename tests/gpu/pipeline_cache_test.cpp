// The pipeline cache file: its own checksum finds every damage, and no state of the file or its folder
// keeps a device from being made.
#include "devices.hpp"
#include "vulkan_spy.hpp"
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gpu/pipeline_cache.hpp>
#include <image/temporary_folder.hpp>

namespace prelight {
namespace {

using Bytes = std::vector<std::byte>;

Bytes some_bytes(size_t size) {
    Bytes bytes(size);
    uint32_t state = 1;
    for (std::byte& b : bytes)
        b = static_cast<std::byte>((state = state * 1664525 + 1013904223) >> 24);
    return bytes;
}

Bytes opened(const Bytes& file) {
    const auto payload = gpu::open_cache(file);
    return {payload.begin(), payload.end()};
}

TEST(PipelineCacheFrame, RoundTrip) {
    for (const size_t size : {size_t(1), size_t(32), size_t(4096), size_t(100'000)}) {
        const Bytes payload = some_bytes(size);
        EXPECT_EQ(opened(gpu::seal_cache(payload)), payload);
    }
    EXPECT_TRUE(opened(gpu::seal_cache({})).empty());
}

TEST(PipelineCacheFrame, EveryFlippedBitIsFound) {
    const Bytes file = gpu::seal_cache(some_bytes(500));
    for (size_t i = 0; i < file.size(); ++i)
        for (int bit = 0; bit < 8; ++bit) {
            Bytes damaged = file;
            damaged[i] ^= static_cast<std::byte>(1 << bit);
            EXPECT_TRUE(opened(damaged).empty()) << "byte " << i << " bit " << bit;
        }
}

TEST(PipelineCacheFrame, EveryTruncationAndExtensionIsFound) {
    const Bytes file = gpu::seal_cache(some_bytes(500));
    for (size_t size = 0; size < file.size(); ++size)
        EXPECT_TRUE(opened({file.begin(), file.begin() + static_cast<ptrdiff_t>(size)}).empty()) << size;
    Bytes longer = file;
    longer.push_back({});
    EXPECT_TRUE(opened(longer).empty());
}

/// The device's cache file, in a cache folder of the test's own.
class PipelineCacheFile : public testing::Test {
protected:
    static std::unique_ptr<gpu::Context> device() {
        return std::make_unique<gpu::Context>(DeviceOptions{.select = "cpu"});
    }
    /// Where a device of this process writes; makes and ends one.
    std::filesystem::path written_file() const {
        device();
        std::filesystem::path found;
        for (const auto& entry : std::filesystem::directory_iterator(folder_.path / "prelight")) {
            EXPECT_TRUE(found.empty()) << "more than one file, or a temporary one left behind";
            found = entry.path();
        }
        return found;
    }
    static Bytes read(const std::filesystem::path& file) {
        std::ifstream in(file, std::ios::binary);
        std::string text((std::istreambuf_iterator<char>(in)), {});
        const auto* first = reinterpret_cast<const std::byte*>(text.data());
        return {first, first + text.size()};
    }
    static void write(const std::filesystem::path& file, const Bytes& bytes) {
        std::ofstream out(file, std::ios::binary | std::ios::trunc);
        out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    TemporaryFolder folder_;
    ScopedVariable cache_home_{"XDG_CACHE_HOME", folder_.path.c_str()};
};

TEST_F(PipelineCacheFile, IsWrittenWholeWhenTheDeviceEnds) {
    const auto file = written_file();
    ASSERT_FALSE(file.empty());
    EXPECT_EQ(file.parent_path(), folder_.path / "prelight");
    EXPECT_FALSE(opened(read(file)).empty());
    EXPECT_EQ(written_file(), file) << "the second device, which reads it, uses the same one";
}

TEST_F(PipelineCacheFile, DamageIsIgnoredAndRepaired) {
    const auto file = written_file();
    const Bytes whole = read(file);
    Bytes flipped = whole;
    flipped.back() ^= std::byte{1};
    const Bytes half(whole.begin(), whole.begin() + static_cast<ptrdiff_t>(whole.size() / 2));
    for (const Bytes& damaged : {flipped, half, Bytes{}, some_bytes(1000)}) {
        write(file, damaged);
        ASSERT_TRUE(opened(read(file)).empty());
        EXPECT_NO_THROW(device());
        EXPECT_FALSE(opened(read(file)).empty()) << "the next device writes a whole one again";
    }
}

TEST_F(PipelineCacheFile, TheDriverGetsTheWholePayloadOrNothing) {
    const auto file = written_file();
    const Bytes sealed = gpu::seal_cache(some_bytes(1000));
    Bytes flipped = sealed;
    flipped.back() ^= std::byte{1};
    const auto context = device();
    const VulkanSpy spy;
    write(file, flipped);
    gpu::load_pipeline_cache(context->device(), file);
    write(file, sealed);
    gpu::load_pipeline_cache(context->device(), file);
    std::filesystem::remove(file);
    gpu::load_pipeline_cache(context->device(), file);
    EXPECT_EQ(spy.pipeline_caches, (std::vector<Bytes>{{}, some_bytes(1000), {}}));
}

TEST_F(PipelineCacheFile, WithoutPermissionIsNoFailure) {
    using std::filesystem::perms;
    const auto file = written_file();
    std::filesystem::permissions(file, perms::none);
    std::filesystem::permissions(file.parent_path(), perms::owner_read | perms::owner_exec);
    EXPECT_NO_THROW(device());
    std::filesystem::permissions(file.parent_path(), perms::owner_all);
    std::filesystem::permissions(file, perms::owner_all);
    EXPECT_EQ(written_file(), file);
}

// Root may write anywhere, so that these stand in for what permissions do to other users.
TEST_F(PipelineCacheFile, AFileWhereTheFolderShouldBeIsNoFailure) {
    write(folder_.path / "prelight", some_bytes(10));
    EXPECT_NO_THROW(device());
    EXPECT_EQ(read(folder_.path / "prelight"), some_bytes(10));
}

TEST_F(PipelineCacheFile, AFolderWhereTheFileShouldBeIsNoFailure) {
    const auto file = written_file();
    std::filesystem::remove(file);
    std::filesystem::create_directory(file);
    EXPECT_NO_THROW(device());
    EXPECT_TRUE(std::filesystem::is_directory(file));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(file.parent_path()), {}), 1)
        << "the temporary file is gone";
}

TEST_F(PipelineCacheFile, WithoutHomeThereIsNone) {
    const ScopedVariable no_cache("XDG_CACHE_HOME", nullptr), no_home("HOME", nullptr);
    VkPhysicalDeviceProperties properties{};
    EXPECT_TRUE(gpu::pipeline_cache_file(properties).empty());
    EXPECT_NO_THROW(device());
}

TEST_F(PipelineCacheFile, IsNamedByDriverAndDevice) {
    VkPhysicalDeviceProperties a{}, b{};
    b.pipelineCacheUUID[15] = 1;
    EXPECT_NE(gpu::pipeline_cache_file(a), gpu::pipeline_cache_file(b));
    const ScopedVariable no_cache("XDG_CACHE_HOME", nullptr), home("HOME", folder_.path.c_str());
    EXPECT_EQ(gpu::pipeline_cache_file(a).parent_path(), folder_.path / ".cache" / "prelight");
}

} // namespace
} // namespace prelight
