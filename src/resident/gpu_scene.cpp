#include "gpu_scene.hpp"
#include <algorithm>
#include <array>
#include <glm/matrix.hpp>

namespace prelight::resident {

GpuScene::GpuScene(const gpu::Context& context, const World& world, const GpuSceneSettings& settings)
    : context_(context), world_(world), settings_(settings), updates_(context),
      materials_(upload_materials(context, *world.scene, settings.texture_filter, settings.exposure)),
      decals_(decal_boxes(world)), geometry_(upload_geometry(context, world, settings, materials_.shaders, decals_)),
      box_(box_around(geometry_.draws)) {
    for (uint32_t d = 0; d < world.deformed.size() && !deformation_; ++d)
        if (deforms_on_device(world, d) && !geometry_.deformed[d].empty())
            deformation_.emplace(context, world, geometry_);
    for (const Instance& instance : world.instances)
        shown_.emplace_back(instance.mesh, instance.deformed);
    for (const Draw& draw : geometry_.draws) {
        has_[static_cast<size_t>(draw.draw_class())] = true;
        softens_ = softens_ || (draw.features & FEATURE_SOFT) != 0;
    }
    if (settings.casters)
        upload_casters();
}

std::array<glm::vec4, 3> GpuScene::caster_row(const Draw& draw) const {
    glm::dmat4 m = world_.instances[draw.object].transform;
    m[3] -= glm::dvec4(box_.centre(), 0);
    m = glm::transpose(m);
    return {glm::vec4(m[0]), glm::vec4(m[1]), glm::vec4(m[2])};
}

void GpuScene::upload_casters() {
    std::vector<std::array<glm::vec4, 3>> rows;
    for (const Draw& draw : geometry_.draws)
        rows.push_back(caster_row(draw));
    caster_rows_ = gpu::make_device_buffer(context_, "shadow casters", std::as_bytes(std::span(rows)),
                                           VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
}

} // namespace prelight::resident
