// CPU time of each pass, measured by submitting it alone.
#include "garden.hpp"

namespace prelight {
namespace {

std::unique_ptr<Renderer> rendered(const Garden& garden, const Shot& shot, bool pass_cpu) {
    RenderOptions options = options_of(shot);
    options.pass_cpu = pass_cpu;
    options.count_pairs = true;
    auto renderer = create_renderer(shot.renderer, &test_device(), options);
    renderer->set_world(garden.world);
    renderer->render(garden.camera, 3);
    return renderer;
}

TEST(PassTimes, EachPassAloneTakesItsShareOfTheFrameAndLeavesTheSamePicture) {
    Garden garden;
    garden.add_lights(60, 4, 6);
    for (const char* culling : {"volumes", "clusters"}) {
        SCOPED_TRACE(culling);
        Shot shot = garden.shot();
        shot.settings["light-culling"] = culling;
        const auto plain = rendered(garden, shot, false), timed = rendered(garden, shot, true);
        for (const PassStats& pass : plain->stats().passes)
            EXPECT_FALSE(pass.cpu_ms.has_value()) << pass.name;
        double sum = 0;
        const Stats stats = timed->stats();
        for (const PassStats& pass : stats.passes) {
            ASSERT_TRUE(pass.cpu_ms.has_value()) << pass.name;
            EXPECT_GT(pass.cpu_ms->max, 0) << pass.name;
            sum += pass.cpu_ms->median;
        }
        // The rest of a frame is what the host does before it records.
        EXPECT_GT(sum, 0.3 * stats.cpu_ms.min);
        EXPECT_LT(sum, 3 * stats.cpu_ms.max);
        EXPECT_TRUE(timed->read("linear").pixels == plain->read("linear").pixels);
        EXPECT_EQ(stats.frames, 3u);
        EXPECT_EQ(stats.pairs_evaluated, plain->stats().pairs_evaluated);
    }
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
