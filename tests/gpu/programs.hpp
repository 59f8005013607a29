#pragma once
#include <array>
#include <gpu/context.hpp>
#include <gpu/shader_key.hpp>
#include <graph/frame_graph.hpp>
#include <span>
#include <string_view>

namespace prelight::gpu {
/// SPIR-V of a file in tests/gpu/shaders. Throws Error for another name.
std::span<const uint32_t> find_test_shader(const ShaderKey& key);
} // namespace prelight::gpu

namespace prelight {

/// A pipeline of one of the tests' shaders, with one descriptor set and a push constant of four
/// floats. The test shaders are small on purpose: what a pass computes here can be done in the head.
class Program {
public:
    /// A .comp shader without `attachments`, else a .frag shader that draws everywhere.
    Program(const gpu::Context& context, std::string_view shader, VkDescriptorSetLayout set,
            const gpu::Attachments& attachments = {});
    /// One workgroup for each of x × y × 1, or one full-screen triangle.
    void run(VkCommandBuffer commands, VkDescriptorSet set, std::array<float, 4> push = {}, uint32_t groups_x = 1,
             uint32_t groups_y = 1) const;

private:
    void make_compute(const gpu::Context& context, VkShaderModule shader);
    void make_graphics(const gpu::Context& context, VkShaderModule shader, const gpu::Attachments& attachments);
    gpu::UniquePipelineLayout layout_;
    gpu::UniquePipeline pipeline_;
    VkPipelineBindPoint point_ = VK_PIPELINE_BIND_POINT_COMPUTE;
};

/// Gives `pass` a program that draws everywhere, or is dispatched once.
void run_program(graph::Pass& pass, const gpu::Context& context, const std::string& shader,
                 std::array<float, 4> push = {}, uint32_t groups_x = 1, uint32_t groups_y = 1);

/// Records `graph` once on the context and waits.
void run_frame(const gpu::Context& context, graph::FrameGraph& graph);

/// What read_back() gave, as values of type T.
template <class T>
std::vector<T> texels(const graph::FrameGraph& graph, graph::ImageId image) {
    const std::vector<std::byte> bytes = graph.read_back(image);
    std::vector<T> values(bytes.size() / sizeof(T));
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<std::byte*>(values.data()));
    return values;
}

} // namespace prelight
