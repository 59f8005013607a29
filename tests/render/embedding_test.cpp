// Prelight on another program's device: prelight/vulkan.hpp.
#include "garden.hpp"
#include "own_vulkan.hpp"
#include <algorithm>
#include <glm/gtc/packing.hpp>
#include <mutex>
#include <prelight/error.hpp>
#include <thread>

namespace prelight {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

constexpr uint32_t own_width = 96, own_height = 54;

RenderOptions small_options() { return {.width = own_width, .height = own_height}; }

struct EmbeddedGarden : Garden {
    EmbeddedGarden() { add_lights(20, 3, 4); }
};

std::unique_ptr<Renderer> garden_renderer(Device& device, const World& world, const char* name = "light-prepass",
                                          const RenderOptions& options = small_options()) {
    auto renderer = create_renderer(name, &device, options);
    renderer->set_world(world);
    return renderer;
}

Image garden_picture(Device& device, const EmbeddedGarden& garden, const char* name = "light-prepass") {
    const auto renderer = garden_renderer(device, garden.world, name);
    renderer->render(garden.camera);
    return renderer->read("final");
}

class AdoptedDevice : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Drivers, AdoptedDevice, testing::Bool(),
                         [](const auto& driver) { return driver.param ? "swiftshader" : "lavapipe"; });

TEST_P(AdoptedDevice, DrawsTheSamePictureAndLeavesNothingBehind) {
    if (GetParam() && !OwnVulkan::has_swiftshader())
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium has it)";
    const EmbeddedGarden garden;
    OwnVulkan own(GetParam());
    Image adopted;
    {
        const auto device = Device::adopt(own.handles());
        adopted = garden_picture(*device, garden);
        EXPECT_EQ(vulkan::handles(*device).queue, own.handles().queue);
    }
    own.run([](VkCommandBuffer) {}); // it is there still
    EXPECT_THAT(own.destroy(), IsEmpty());
    Device* const device = GetParam() ? swiftshader_device() : nullptr;
    EXPECT_TRUE(adopted.pixels == garden_picture(device ? *device : test_device(), garden).pixels);
}

// What a device was made without is not used: validation would tell.
TEST(Adopting, DoesWithoutWhatIsOptional) {
    const EmbeddedGarden garden;
    OwnVulkan own(false, [](vulkan::DeviceFeatures& features) {
        const VkBool32 needed = features.core.features.fragmentStoresAndAtomics;
        features.core.features = {};
        features.core.features.fragmentStoresAndAtomics = needed;
        features.extensions.clear();
    });
    {
        const auto device = Device::adopt(own.handles());
        EXPECT_GT(compare_pixels(garden_picture(*device, garden), garden_picture(test_device(), garden)).psnr, 50);
        EXPECT_FALSE(device->has_samples(4)) << "sample shading is not enabled";
    }
    EXPECT_THAT(own.destroy(), IsEmpty());
}

TEST(Adopting, RefusesWhatWillNotDo) {
    const OwnVulkan own;
    const auto refusal = [&](const std::function<void(vulkan::ExistingDevice&)>& spoil, const char* reason) {
        vulkan::ExistingDevice given = own.handles();
        spoil(given);
        EXPECT_THAT([&] { Device::adopt(given); }, ThrowsMessage<Error>(HasSubstr(reason)));
    };
    refusal([](auto& given) { given.queue = VK_NULL_HANDLE; }, "queue are all needed");
    refusal([](auto& given) { given.queue_family = 7; }, "queue family 7");
    refusal([](auto& given) { given.lock_queue = [] {}; }, "come together");
    refusal([](auto& given) { given.enabled.vulkan13.synchronization2 = VK_FALSE; }, "without synchronization2");
    refusal([](auto& given) { given.enabled = {}; },
            "dynamicRendering, synchronization2, maintenance4, timelineSemaphore, fragmentStoresAndAtomics");
    refusal([](auto& given) { given.physical_device = vulkan::handles(test_device()).physical_device; },
            "not one of the instance's");
    EXPECT_THROW(vulkan::wanted_features(VK_NULL_HANDLE), UsageError);
}

// The program's own lock is held around each use of the queue, and not twice.
TEST(Adopting, LocksTheQueueWithTheProgram) {
    const EmbeddedGarden garden;
    const OwnVulkan own;
    std::mutex mutex;
    int held = 0, uses = 0;
    vulkan::ExistingDevice given = own.handles();
    given.lock_queue = [&] {
        mutex.lock();
        ++uses;
        EXPECT_EQ(++held, 1);
    };
    given.unlock_queue = [&] {
        --held;
        mutex.unlock();
    };
    std::atomic<bool> done = false;
    std::thread other([&] { // a program that is busy with the same queue
        while (!done) {
            const std::scoped_lock lock(mutex);
            own.run([](VkCommandBuffer) {});
        }
    });
    const auto device = Device::adopt(given);
    const Image picture = garden_picture(*device, garden);
    done = true;
    other.join();
    EXPECT_GT(uses, 2);
    EXPECT_EQ(held, 0);
    EXPECT_TRUE(picture.pixels == garden_picture(test_device(), garden).pixels);
    EXPECT_THAT(own.messages(), IsEmpty());
}

class IntoAnImage : public testing::Test {
protected:
    /// Draws into an image of this format, and reads it as the next user of the queue does.
    std::vector<std::byte> drawn(Renderer& renderer, VkFormat format, uint32_t texel_bytes,
                                 const std::string& buffer = "final") {
        const OwnImage image(own_, format, own_width, own_height);
        vulkan::Target target = image.target();
        target.layout_after = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
        target.buffer = buffer;
        vulkan::render_into(renderer, garden_.camera, target);
        target.layout_before = target.layout_after; // and again, as it lies there
        vulkan::render_into(renderer, garden_.camera, target);
        return image.read(target.layout_after, texel_bytes);
    }
    /// Values of three channels in this order, as read() gives them.
    static void expect_bytes(const std::vector<std::byte>& texels, const Image& picture, std::array<int, 3> order,
                             float tolerance) {
        for (size_t i = 0; i < picture.pixels.size(); ++i)
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(float(texels[4 * i + order[c]]), picture.pixels[i][c] * 255, tolerance) << i;
    }
    void TearDown() override {
        device_.reset();
        EXPECT_THAT(own_.messages(), IsEmpty());
    }

    const EmbeddedGarden garden_;
    const OwnVulkan own_;
    std::unique_ptr<Device> device_ = Device::adopt(own_.handles());
};

TEST_F(IntoAnImage, HoldsWhatReadGives) {
    const auto renderer = garden_renderer(*device_, garden_.world);
    renderer->render(garden_.camera);
    const Image picture = renderer->read("final");
    expect_bytes(drawn(*renderer, VK_FORMAT_R8G8B8A8_UNORM, 4), picture, {0, 1, 2}, 0.01f);
    expect_bytes(drawn(*renderer, VK_FORMAT_B8G8R8A8_UNORM, 4), picture, {2, 1, 0}, 0.01f);
    expect_bytes(drawn(*renderer, VK_FORMAT_B8G8R8A8_SRGB, 4), picture, {2, 1, 0}, 1.01f);
    EXPECT_TRUE(renderer->read("final").pixels == picture.pixels) << "read() goes on";
    renderer->render(garden_.camera); // a frame without a target
    EXPECT_TRUE(renderer->read("final").pixels == picture.pixels);
    const Stats stats = renderer->stats();
    EXPECT_TRUE(std::ranges::any_of(stats.passes, [](const PassStats& pass) { return pass.name == "target"; }));
}

TEST_F(IntoAnImage, HoldsOtherBuffersToo) {
    RenderOptions options = small_options();
    options.views = {"linear", "normal"};
    const auto renderer = garden_renderer(*device_, garden_.world, "light-prepass", options);
    renderer->render(garden_.camera);
    expect_bytes(drawn(*renderer, VK_FORMAT_R8G8B8A8_UNORM, 4, "normal"), renderer->read("normal"), {0, 1, 2}, 0.01f);
    const Image linear = renderer->read("linear");
    const std::vector<std::byte> texels = drawn(*renderer, VK_FORMAT_R16G16B16A16_SFLOAT, 8, "linear");
    const auto* halves = reinterpret_cast<const uint16_t*>(texels.data());
    for (size_t i = 0; i < linear.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_EQ(glm::unpackHalf1x16(halves[4 * i + size_t(c)]), linear.pixels[i][c]) << i;
}

TEST_F(IntoAnImage, WorksInEveryArchitectureAndAfterAnotherSize) {
    for (const RendererInfo& info : renderer_infos()) {
        if (!info.needs_device)
            continue;
        SCOPED_TRACE(info.name);
        RenderOptions options = small_options();
        options.width = 40;
        options.msaa = info.name == "light-prepass" ? 4 : 1;
        const auto renderer = garden_renderer(*device_, garden_.world, info.name.c_str(), options);
        renderer->render(garden_.camera);
        renderer->resize(own_width, own_height);
        const std::vector<std::byte> texels = drawn(*renderer, VK_FORMAT_R8G8B8A8_UNORM, 4);
        expect_bytes(texels, renderer->read("final"), {0, 1, 2}, 0.01f);
    }
}

TEST_F(IntoAnImage, WaitsAndSignals) {
    const auto renderer = garden_renderer(*device_, garden_.world);
    renderer->render(garden_.camera);
    renderer->stats();
    const OwnImage image(own_, VK_FORMAT_R8G8B8A8_UNORM, own_width, own_height);
    vulkan::Target target = image.target();
    const VkSemaphore ready = own_.make_timeline(), finished = own_.make_timeline();
    target.wait = {{ready, 3, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT}};
    target.signal = {{finished, 5}};
    vulkan::render_into(*renderer, garden_.camera, target);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_EQ(own_.value_of(finished), 0u) << "nobody has signalled what it waits for";
    own_.signal(ready, 3);
    renderer->stats(); // waits for the frame
    EXPECT_EQ(own_.value_of(finished), 5u);
}

TEST_F(IntoAnImage, RefusesWhatWillNotDo) {
    const auto renderer = create_renderer("light-prepass", device_.get(), small_options());
    const OwnImage image(own_, VK_FORMAT_R8G8B8A8_UNORM, own_width, own_height);
    EXPECT_THAT([&] { vulkan::render_into(*renderer, garden_.camera, image.target()); },
                ThrowsMessage<Error>(HasSubstr("set_world()")));
    renderer->set_world(garden_.world);
    const auto refusal = [&](const std::function<void(vulkan::Target&)>& spoil, const char* reason) {
        vulkan::Target target = image.target();
        spoil(target);
        EXPECT_THAT([&] { vulkan::render_into(*renderer, garden_.camera, target); },
                    ThrowsMessage<UsageError>(HasSubstr(reason)));
    };
    refusal([](auto& target) { target.view = VK_NULL_HANDLE; }, "image and view");
    refusal([](auto& target) { target.format = VK_FORMAT_R8_UNORM; }, "VkFormat 9");
    refusal([](auto& target) { target.extent.width = 12; }, "12x54 pixels, where the renderer's pictures have 96x54");
    refusal([](auto& target) { target.layout_after = VK_IMAGE_LAYOUT_UNDEFINED; }, "layout_after");
    refusal([](auto& target) { target.signal = {{}}; }, "semaphore");
    refusal([](auto& target) { target.buffer = "normal"; }, "was not asked for");
    const auto reference = create_renderer("reference", nullptr, small_options());
    EXPECT_THROW(vulkan::render_into(*reference, garden_.camera, image.target()), UsageError);
}

TEST(TexelsOfAFrame, AreThoseOfReadAndStay) {
    EmbeddedGarden garden;
    RenderOptions options = small_options();
    options.views = {"linear"};
    const auto renderer = garden_renderer(test_device(), garden.world, "light-prepass", options);
    renderer->render(garden.camera);
    const Image final = renderer->read("final"), linear = renderer->read("linear");
    const Texels bytes = renderer->texels("final"), halves = renderer->texels("linear");
    garden.world.lights.clear();
    renderer->set_lights(garden.world.lights);
    renderer->render(garden.camera); // another picture
    EXPECT_FALSE(renderer->read("final").pixels == final.pixels);
    ASSERT_EQ(bytes.format, Texels::Format::rgba8);
    ASSERT_EQ(halves.format, Texels::Format::rgba16f);
    ASSERT_EQ(bytes.width, own_width);
    ASSERT_EQ(bytes.height, own_height);
    ASSERT_EQ(bytes.bytes.size(), final.pixels.size() * 4);
    ASSERT_EQ(halves.bytes.size(), final.pixels.size() * 8);
    const auto* values = reinterpret_cast<const uint16_t*>(halves.bytes.data());
    for (size_t i = 0; i < final.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            ASSERT_EQ(float(bytes.bytes[4 * i + size_t(c)]) / 255, final.pixels[i][c]) << i;
            ASSERT_EQ(glm::unpackHalf1x16(values[4 * i + size_t(c)]), linear.pixels[i][c]) << i;
        }
    EXPECT_THROW(renderer->texels("normal"), UsageError);
    expect_validation_clean(test_device());
}

TEST(TexelsOfAFrame, OfTheReferenceAreFloats) {
    const EmbeddedGarden garden;
    const auto renderer = create_renderer("reference", nullptr, {.width = 8, .height = 6});
    renderer->set_world(garden.world);
    renderer->render(garden.camera);
    const Texels texels = renderer->texels("linear");
    ASSERT_EQ(texels.format, Texels::Format::rgb32f);
    ASSERT_EQ(texels.bytes.size(), 8u * 6 * 12);
    const Image linear = renderer->read("linear");
    EXPECT_EQ(std::memcmp(texels.bytes.data(), linear.pixels.data(), texels.bytes.size()), 0);
}

// Renderers of one device, each in a thread of its own.
TEST(RenderersInThreads, DrawWhatTheyDrawAlone) {
    const EmbeddedGarden garden;
    const std::vector<const char*> names{"light-prepass", "deferred", "z-prepass"};
    std::vector<Image> alone;
    for (const char* name : names)
        alone.push_back(garden_picture(test_device(), garden, name));
    std::vector<std::thread> threads;
    std::vector<int> equal(names.size());
    for (size_t t = 0; t < names.size(); ++t)
        threads.emplace_back([&, t] {
            for (int round = 0; round < 3; ++round) { // worlds come and go, pictures are read
                const auto renderer = garden_renderer(test_device(), garden.world, names[t]);
                for (int frame = 0; frame < 4; ++frame) {
                    renderer->set_lights(garden.world.lights);
                    renderer->render(garden.camera);
                    equal[t] += renderer->read("final").pixels == alone[t].pixels;
                }
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_THAT(equal, testing::Each(12));
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
