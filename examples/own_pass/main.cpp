// A pass of a program's own in a frame: lines that show how far lights reach, drawn over the finished picture where no
// surface hides them. example_own_pass [PICTURE.png]
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <lines.frag.h> // SPIR-V that the build makes of the shaders beside this file
#include <lines.vert.h>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <prelight/vulkan.hpp>

namespace {

using namespace prelight;

/// Draws the lights of a world as circles. Alive as long as the pass is in a renderer.
class LightLines {
public:
    LightLines(const Device& device, const World& world) : device_(vulkan::handles(device).device), world_(world) {
        const VkPushConstantRange constants{VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(Constants)};
        VkPipelineLayoutCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
        info.pushConstantRangeCount = 1;
        info.pPushConstantRanges = &constants;
        check(vkCreatePipelineLayout(device_, &info, nullptr, &layout_));
    }
    ~LightLines() {
        vkDestroyPipeline(device_, pipeline_, nullptr);
        vkDestroyPipelineLayout(device_, layout_, nullptr);
    }
    LightLines(const LightLines&) = delete;
    LightLines& operator=(const LightLines&) = delete;

    vulkan::Pass pass() {
        return {.name = "light lines",
                .stage = vulkan::Stage::after_display,
                .writes = {"picture"},
                .depth_test = true,
                .prepare = [this](const vulkan::PassImages& images) { make_pipeline(images); },
                .record = [this](const vulkan::PassFrame& frame) { record(frame); }};
    }

private:
    struct Constants {
        glm::mat4 clip_from_world;
        glm::vec4 sphere; ///< centre relative to the camera, radius
    };

    static void check(VkResult result) {
        if (result != VK_SUCCESS)
            throw Error("light lines: VkResult " + std::to_string(result));
    }

    template <size_t Words>
    VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits kind, const uint32_t (&code)[Words]) const {
        VkShaderModuleCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
        info.codeSize = sizeof code;
        info.pCode = code;
        VkPipelineShaderStageCreateInfo made{};
        made.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        made.stage = kind;
        made.pName = "main";
        check(vkCreateShaderModule(device_, &info, nullptr, &made.module));
        return made;
    }

    /// For the attachments as they are now.
    void make_pipeline(const vulkan::PassImages& images) {
        vkDestroyPipeline(device_, pipeline_, nullptr);
        pipeline_ = VK_NULL_HANDLE;
        const std::array stages{stage(VK_SHADER_STAGE_VERTEX_BIT, lines_vert),
                                stage(VK_SHADER_STAGE_FRAGMENT_BIT, lines_frag)};
        VkPipelineVertexInputStateCreateInfo vertices{};
        vertices.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
        VkPipelineInputAssemblyStateCreateInfo assembly{};
        assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
        assembly.topology = VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
        VkPipelineViewportStateCreateInfo viewport{};
        viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
        viewport.viewportCount = viewport.scissorCount = 1;
        VkPipelineRasterizationStateCreateInfo raster{};
        raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
        raster.lineWidth = 1;
        VkPipelineMultisampleStateCreateInfo samples{};
        samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
        samples.rasterizationSamples = static_cast<VkSampleCountFlagBits>(images.writes.at(0).samples);
        VkPipelineDepthStencilStateCreateInfo depth{};
        depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
        depth.depthTestEnable = VK_TRUE;
        depth.depthCompareOp = VK_COMPARE_OP_GREATER_OR_EQUAL; // depth is reversed
        VkPipelineColorBlendAttachmentState target{};
        target.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT;
        VkPipelineColorBlendStateCreateInfo blend{};
        blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
        blend.attachmentCount = 1;
        blend.pAttachments = &target;
        const VkDynamicState states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
        VkPipelineDynamicStateCreateInfo dynamic{};
        dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
        dynamic.dynamicStateCount = 2;
        dynamic.pDynamicStates = states;
        VkPipelineRenderingCreateInfo rendering{};
        rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
        rendering.colorAttachmentCount = 1;
        rendering.pColorAttachmentFormats = &images.writes.at(0).format;
        rendering.depthAttachmentFormat = images.depth_test->format;
        VkGraphicsPipelineCreateInfo info{};
        info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
        info.pNext = &rendering;
        info.stageCount = 2;
        info.pStages = stages.data();
        info.pVertexInputState = &vertices;
        info.pInputAssemblyState = &assembly;
        info.pViewportState = &viewport;
        info.pRasterizationState = &raster;
        info.pMultisampleState = &samples;
        info.pDepthStencilState = &depth;
        info.pColorBlendState = &blend;
        info.pDynamicState = &dynamic;
        info.layout = layout_;
        const VkResult result = vkCreateGraphicsPipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_);
        for (const VkPipelineShaderStageCreateInfo& one : stages)
            vkDestroyShaderModule(device_, one.module, nullptr);
        check(result);
    }

    void record(const vulkan::PassFrame& frame) const {
        vkCmdBindPipeline(frame.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
        for (const PlacedLight& placed : world_.lights) {
            const Constants constants{frame.clip_from_world,
                                      glm::vec4(glm::vec3(placed.position - frame.eye), placed.light.range)};
            vkCmdPushConstants(frame.commands, layout_, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof constants, &constants);
            vkCmdDraw(frame.commands, 3 * 64, 1, 0, 0);
        }
    }

    VkDevice device_;
    const World& world_;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

void run(const char* picture) {
    const Scene scene = make_scene("lights", 12, 1);
    const World world = resolve(scene);
    const std::unique_ptr<Device> device = Device::create({.validate = std::getenv("EXAMPLE_VALIDATE") != nullptr});
    LightLines lines(*device, world);
    const auto renderer = create_renderer("light-prepass", device.get(), {.width = 640, .height = 360});
    renderer->set_world(world);
    vulkan::add_pass(*renderer, lines.pass());
    renderer->render(world.cameras.at(0));
    save_png(renderer->read("final"), picture);
    for (const std::string& message : device->validation_messages())
        throw Error(message);
}

} // namespace

int main(int argc, char** argv) {
    try {
        run(argc > 1 ? argv[1] : "own-pass.png");
        return 0;
    } catch (const prelight::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
