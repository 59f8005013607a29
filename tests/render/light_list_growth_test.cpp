// Lists that do not fit walk all lights in that frame, and have room in the next.
#include "garden.hpp"
#include <gpu/context.hpp>
#include <gpu/world_view.hpp>
#include <passes/light_pass.hpp>

namespace prelight {
namespace {

struct GrowthCase {
    const char* name;
    resident::LightCulling culling;
    passes::ListShading shading = passes::ListShading::fragment;
    uint64_t times = 2; ///< what walking all lights evaluates, at least: so many times what lists hold
};
void PrintTo(const GrowthCase& c, std::ostream* out) { *out << c.name; }

/// Depth, normals and a light pass by lists whose buffer begins with room for `room` entries.
class ListedGarden {
public:
    ListedGarden(const Garden& garden, const GrowthCase& c, uint64_t room)
        : context_(dynamic_cast<gpu::Context&>(test_device())),
          counters_(context_, "pair counters", 90 * 2 * sizeof(uint32_t), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT,
                    gpu::BufferPlace::readback),
          on_device_(context_, garden.world, {.raster = {{160, 90}}, .culling = c.culling}), graph_(context_) {
        const passes::LightModel model;
        const auto surface = passes::depth_normal_pass(graph_, view_, {});
        light_ = passes::make_light_buffer(graph_, view_, model);
        passes::LightingInputs lighting{.surface = surface,
                                        .model = model,
                                        .target = light_.target,
                                        .pair_counters = &counters_,
                                        .count_pairs = true};
        lighting.lists = passes::screen_light_lists(graph_, view_, "light", lighting,
                                                    {.tile_size = 8, .shading = c.shading, .first_room = room});
        passes::light_pass(graph_, view_, "light", lighting);
        graph_.keep(light_.diffuse);
        graph_.keep(light_.specular);
        graph_.compile();
        view_.update(garden.camera);
    }
    struct Result {
        std::vector<std::byte> diffuse, specular;
        uint64_t evaluated = 0, contributing = 0, bytes = 0;
    };
    Result render() {
        uint32_t* rows = counters_.mapped<uint32_t>();
        std::fill_n(rows, 180, 0u);
        context_.run("frame", [&](VkCommandBuffer commands) { graph_.record(commands); });
        Result result{graph_.read_back(light_.diffuse), graph_.read_back(light_.specular), 0, 0,
                      context_.device_bytes()};
        for (int y = 0; y < 90; ++y) {
            result.evaluated += rows[2 * y];
            result.contributing += rows[2 * y + 1];
        }
        return result;
    }

private:
    const gpu::Context& context_;
    gpu::Buffer counters_;
    WorldView on_device_;
    resident::View& view_ = on_device_.view;
    graph::FrameGraph graph_;
    passes::LightBuffer light_;
};

class ListGrowth : public testing::TestWithParam<GrowthCase> {};
const auto growth_name = [](const auto& info) { return std::string(info.param.name); };
// The compute pass asks itself which lights reach a block: all lights are walked, and few more evaluated.
INSTANTIATE_TEST_SUITE_P(Tiles, ListGrowth,
                         testing::Values(GrowthCase{"tiles", resident::LightCulling::tiles},
                                         GrowthCase{"tiles_compute", resident::LightCulling::tiles,
                                                    passes::ListShading::compute, 1}),
                         growth_name);
INSTANTIATE_TEST_SUITE_P(Clusters, ListGrowth,
                         testing::Values(GrowthCase{"clusters", resident::LightCulling::clusters}), growth_name);

TEST_P(ListGrowth, ListsThatDoNotFitWalkAllLightsAndFitInTheNextFrame) {
    Garden garden;
    garden.add_lights(200, 2, 3);
    garden.add_light({.kind = LightKind::directional, .intensity = 0.4f}, {0, 0, 0}, {-0.3, -1, -0.5});
    ListedGarden ample(garden, GetParam(), 1 << 20), tiny(garden, GetParam(), 1), half(garden, GetParam(), 1000);
    const auto right = ample.render();
    const auto first = tiny.render(), second = tiny.render(), third = tiny.render();
    const auto partly = half.render();
    for (const auto* result : {&first, &second, &third, &partly}) {
        EXPECT_TRUE(result->diffuse == right.diffuse); // all lights stand in the same order as listed ones
        EXPECT_TRUE(result->specular == right.specular);
        EXPECT_EQ(result->contributing, right.contributing);
    }
    EXPECT_GT(first.evaluated, GetParam().times * second.evaluated);
    EXPECT_LT(partly.evaluated, first.evaluated);
    EXPECT_GT(partly.evaluated, right.evaluated);
    EXPECT_EQ(second.evaluated, right.evaluated);
    EXPECT_EQ(third.evaluated, right.evaluated);
    EXPECT_GT(second.bytes, first.bytes);
    EXPECT_EQ(third.bytes, second.bytes) << "a steady frame allocates nothing";
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
