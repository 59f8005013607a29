#pragma once
#include <gpu/buffer.hpp>
#include <gpu/pipeline.hpp>
#include <resident/view.hpp>

namespace prelight::passes {

struct VolumeMesh;

/// The volumes' meshes on the device: a sphere, and a spot's cone or box.
class DeviceVolumes {
public:
    explicit DeviceVolumes(const resident::View& view);
    /// Vertex stage and its inputs.
    void describe(gpu::GraphicsPipelineDesc& desc, bool spot) const;
    /// One instance for each of `count` lights from place `first` of the frame's order.
    void draw(VkCommandBuffer commands, bool spot, uint32_t count, uint32_t first) const;

private:
    struct Mesh {
        gpu::Buffer points, indices;
        uint32_t count = 0;
        Mesh(const gpu::Context& context, const char* name, const VolumeMesh& mesh);
    };
    bool boxes_;
    Mesh sphere_, spot_;
};

} // namespace prelight::passes
