// Renderers on one device share what is built of equal descriptions, and nothing else.
#include "devices.hpp"
#include <chrono>
#include <condition_variable>
#include <functional>
#include <gpu/descriptors.hpp>
#include <gpu/pipeline_library.hpp>
#include <mutex>
#include <thread>

namespace prelight {
namespace {

gpu::GraphicsPipelineDesc tonemap_like() {
    return {.name = "a",
            .vertex = "fullscreen.vert",
            .fragment = "background.frag",
            .attachments = {.colours = {VK_FORMAT_R8G8B8A8_UNORM}}};
}

class Library : public OnDevice {
protected:
    VkDescriptorSetLayout layout(std::initializer_list<VkDescriptorType> types) {
        std::vector<gpu::Binding> bindings;
        for (const VkDescriptorType type : types)
            bindings.push_back({static_cast<uint32_t>(bindings.size()), type});
        return gpu::make_set_layout(context(), "set", bindings);
    }
};

TEST_F(Library, EqualSetLayoutsAreOne) {
    const auto one = layout({VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE});
    EXPECT_EQ(one, layout({VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE}));
    EXPECT_NE(one, layout({VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, VK_DESCRIPTOR_TYPE_SAMPLER}));
    EXPECT_NE(one, layout({VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER}));
}

TEST_F(Library, EqualPipelinesAreBuiltOnce) {
    int calls = 0;
    const auto find = [&](const gpu::GraphicsPipelineDesc& desc) {
        return context().pipelines().find(desc, [&] {
            ++calls;
            return std::make_shared<const gpu::BuiltPipeline>();
        });
    };
    gpu::GraphicsPipelineDesc desc = tonemap_like();
    const auto first = find(desc);
    EXPECT_EQ(find(tonemap_like()), first);
    EXPECT_EQ(calls, 1);
    // Whatever differs is another pipeline.
    std::vector<std::shared_ptr<const gpu::BuiltPipeline>> others;
    for (const std::function<void(gpu::GraphicsPipelineDesc&)>& change :
         std::initializer_list<std::function<void(gpu::GraphicsPipelineDesc&)>>{
             [](auto& d) { d.fragment = "tonemap.frag"; },
             [](auto& d) {
                 d.fragment_code = {1, 2};
             },
             [](auto& d) {
                 d.fragment_code = {1, 3};
             },
             [](auto& d) {
                 d.constants = {{0, 1}};
             },
             [](auto& d) { d.attachments.colours = {VK_FORMAT_R16G16B16A16_SFLOAT}; },
             [](auto& d) { d.attachments.samples = 4; }, [](auto& d) { d.depth_bounds = true; },
             [](auto& d) { d.slope_bias = 1; }, [](auto& d) { d.push_stage = VK_SHADER_STAGE_VERTEX_BIT; },
             [](auto& d) { d.attributes = {{.offset = 4}}; }, [](auto& d) { d.blend = gpu::Blend::add; }}) {
        desc = tonemap_like();
        change(desc);
        others.push_back(find(desc));
        EXPECT_NE(others.back(), first) << others.size();
    }
    EXPECT_EQ(calls, 1 + int(others.size()));
}

TEST_F(Library, BuildsDifferentPipelinesAtOnceAndEqualOnesOnce) {
    std::mutex mutex;
    std::condition_variable both;
    int building = 0, calls = 0;
    bool met = true;
    const auto find = [&](const char* name) {
        context().pipelines().find(gpu::ComputePipelineDesc{.name = name, .shader = "at_once.comp"}, [&] {
            std::unique_lock lock(mutex);
            ++calls;
            ++building;
            both.notify_all();
            met = both.wait_for(lock, std::chrono::seconds(20), [&] { return building == 2; }) && met;
            return std::make_shared<const gpu::BuiltPipeline>();
        });
    };
    {
        std::vector<std::jthread> threads;
        for (const char* name : {"one", "two", "one", "two"})
            threads.emplace_back(find, name);
    }
    EXPECT_TRUE(met) << "one waited for the other to be built";
    EXPECT_EQ(calls, 2);
}

TEST_F(Library, KeepsWhatNobodyUsesAnyMore) {
    int calls = 0;
    for (int i = 0; i < 3; ++i)
        context().pipelines().find(gpu::ComputePipelineDesc{.name = "b", .shader = "b.comp"}, [&] {
            ++calls;
            return std::make_shared<const gpu::BuiltPipeline>();
        });
    EXPECT_EQ(calls, 1);
}

} // namespace
} // namespace prelight
