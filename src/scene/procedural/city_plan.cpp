#include <glm/ext/matrix_transform.hpp>
#include <scene/procedural/builder.hpp>
#include <scene/procedural/city_plan.hpp>

namespace prelight::city {

void Plan::add_point(Rank rank, glm::vec3 position, glm::vec3 colour, float cd, float range) {
    add_site(rank, {.light = {.colour = colour, .intensity = cd, .range = range}, .position = position});
}

uint32_t Plan::add_mesh(Mesh mesh) { return append(scene.meshes, std::move(mesh)); }

void Plan::place(uint32_t mesh, glm::vec3 position, float yaw) {
    const glm::dmat4 local = glm::rotate(translation(position), double(yaw), {0, 1, 0});
    add_root(scene, scene.meshes[mesh].name, local).mesh = mesh;
}

void Plan::build(MeshBuilder& builder, std::string name, glm::vec3 origin) {
    place(add_mesh(builder.finish(std::move(name), origin)), origin);
}

} // namespace prelight::city
