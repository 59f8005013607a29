// Rasters: images of several samples a pixel, and what a pass is told of its own size.
#include "devices.hpp"
#include "programs.hpp"
#include <gmock/gmock.h>

namespace prelight {
namespace {

using graph::FrameGraph;
using graph::ImageId;
using graph::Load;

class FrameGraphRaster : public OnEachDevice {};
INSTANTIATE_TEST_SUITE_P(Drivers, FrameGraphRaster, testing::Values(Driver::lavapipe, Driver::swiftshader),
                         driver_name);

TEST_P(FrameGraphRaster, SamplesArriveEachInItsPlace) {
    constexpr uint32_t width = 16, height = 4;
    FrameGraph graph(context());
    const ImageId four = graph.image("four samples", {VK_FORMAT_R32_SFLOAT, {{width, height}, 4}});
    const ImageId bits = graph.image("bits", {VK_FORMAT_R32G32B32A32_SFLOAT, {{width, height}}});
    graph::Pass& draw = graph.pass("draw");
    draw.colour(four, Load::clear);
    run_program(draw, context(), "some_samples.frag");
    graph::Pass& gather = graph.pass("gather");
    gather.colour(bits, Load::discard).sample(0, four);
    run_program(gather, context(), "gather_samples.frag");
    graph.keep(bits);
    graph.compile();
    run_frame(context(), graph);
    const std::vector<glm::vec4> values = texels<glm::vec4>(graph, bits);
    for (uint32_t i = 0; i < width * height; ++i)
        EXPECT_EQ(values[i], glm::vec4(i % width, width, height, 1)) << i;
    EXPECT_EQ(graph.traffic()[0].bytes_written, width * height * 4 * 4u);
}

TEST_P(FrameGraphRaster, APassMayNameTheRasterThatItReads) {
    FrameGraph graph(context());
    const ImageId four = graph.image("four samples", {VK_FORMAT_R32_SFLOAT, {{32, 8}, 4}});
    const ImageId bits = graph.image("bits", {VK_FORMAT_R32G32B32A32_SFLOAT, {{16, 4}}});
    graph.pass("clear").colour(four, Load::clear, {1}).record([](const auto&) {});
    graph::Pass& gather = graph.pass("gather");
    gather.colour(bits, Load::discard).raster(graph.raster(four)).sample(0, four);
    run_program(gather, context(), "gather_samples.frag");
    graph.keep(bits);
    graph.compile();
    run_frame(context(), graph);
    EXPECT_THAT(texels<glm::vec4>(graph, bits), testing::Each(glm::vec4(15, 32, 8, 1)));
}

} // namespace
} // namespace prelight
