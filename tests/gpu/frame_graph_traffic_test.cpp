// What passes move and what images take, by their formats.
#include "devices.hpp"
#include "programs.hpp"
#include <gmock/gmock.h>

namespace prelight {
namespace {

using graph::FrameGraph;
using graph::ImageDesc;
using graph::ImageId;
using graph::Load;

class FrameGraphTraffic : public OnDevice {};

TEST_F(FrameGraphTraffic, CountsEachImageOnceByItsFormat) {
    constexpr VkExtent2D extent{32, 16};
    constexpr uint64_t texel_count = 32 * 16;
    FrameGraph graph(context());
    const auto nothing = [](const graph::PassContext&) {};
    const ImageId depth = graph.image("depth", {VK_FORMAT_D32_SFLOAT, extent});          // 4 bytes
    const ImageId normal = graph.image("normal", {VK_FORMAT_R8G8B8A8_UNORM, extent});    // 4
    const ImageId light = graph.image("light", {VK_FORMAT_R16G16B16A16_SFLOAT, extent}); // 8
    const ImageId small = graph.image("small", ImageDesc{VK_FORMAT_R8_UNORM, {8, 4}});   // 1
    const ImageId nobody = graph.image("nobody", {VK_FORMAT_R32_SFLOAT, extent});
    graph.pass("fill").colour(normal, Load::clear).depth_write(depth).record(nothing);
    graph.pass("light")
        .colour(light, Load::clear)
        .blends()
        .depth_test(depth)
        .sample(0, depth)
        .sample(1, normal)
        .record(nothing);
    graph.pass("more light").colour(light, Load::keep).depth_write(depth, Load::keep).record(nothing);
    graph.pass("shrink").colour(small, Load::discard).sample(0, light).record(nothing);
    graph.pass("unneeded").colour(nobody, Load::clear).record(nothing);
    graph.keep(small);
    graph.compile();

    const std::vector<graph::PassTraffic> traffic = graph.traffic();
    ASSERT_EQ(traffic.size(), 4u);
    const auto expect = [&](size_t pass, const char* name, uint64_t read, uint64_t written) {
        EXPECT_EQ(traffic[pass].name, name);
        EXPECT_EQ(traffic[pass].bytes_read, read) << name;
        EXPECT_EQ(traffic[pass].bytes_written, written) << name;
    };
    expect(0, "fill", 0, texel_count * (4 + 4));
    expect(1, "light", texel_count * (8 + 4 + 4), texel_count * 8); // blended: read too; depth is read once
    expect(2, "more light", texel_count * (8 + 4), texel_count * (8 + 4));
    expect(3, "shrink", texel_count * 8, 32);
    EXPECT_EQ(graph.unshared_bytes(), texel_count * (4 + 4 + 8) + 32);
    EXPECT_GE(graph.memory_bytes(), texel_count * (4 + 4 + 8)) << "these three are alive at one time";
}

} // namespace
} // namespace prelight
