#include "device_volumes.hpp"
#include "volume_meshes.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

DeviceVolumes::Mesh::Mesh(const gpu::Context& context, const char* name, const VolumeMesh& mesh)
    : points(gpu::make_device_buffer(context, name, std::as_bytes(std::span(mesh.points)),
                                     VK_BUFFER_USAGE_VERTEX_BUFFER_BIT)),
      indices(gpu::make_device_buffer(context, name, std::as_bytes(std::span(mesh.indices)),
                                      VK_BUFFER_USAGE_INDEX_BUFFER_BIT)),
      count(static_cast<uint32_t>(mesh.indices.size())) {}

DeviceVolumes::DeviceVolumes(const resident::View& view)
    : boxes_(view.volumes().spot_boxes), sphere_(view.context(), "sphere volume", sphere_volume()),
      spot_(view.context(), boxes_ ? "box volume" : "cone volume",
            boxes_ ? box_volume() : cone_volume(resident::cone_sides)) {}

void DeviceVolumes::describe(gpu::GraphicsPipelineDesc& desc, bool spot) const {
    desc.vertex = "light_volume.vert";
    desc.constants.emplace_back(CONSTANT_VOLUME, !spot ? VOLUME_SPHERE : boxes_ ? VOLUME_BOX : VOLUME_CONE);
    desc.vertex_strides = {sizeof(glm::vec3)};
    desc.attributes = {{VERTEX_POSITION, 0, VK_FORMAT_R32G32B32_SFLOAT, 0}};
    desc.depth_clamp = true;
}

void DeviceVolumes::draw(VkCommandBuffer commands, bool spot, uint32_t count, uint32_t first) const {
    const Mesh& mesh = spot ? spot_ : sphere_;
    const VkBuffer points = mesh.points.handle();
    const VkDeviceSize offset = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &points, &offset);
    vkCmdBindIndexBuffer(commands, mesh.indices.handle(), 0, VK_INDEX_TYPE_UINT32);
    vkCmdDrawIndexed(commands, mesh.count, count, 0, 0, first);
}

} // namespace prelight::passes
