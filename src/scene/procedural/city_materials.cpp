#include <scene/procedural/city_mesh.hpp>
#include <scene/procedural/city_plan.hpp>
#include <scene/procedural/city_textures.hpp>

namespace prelight::city {
namespace {

TextureRef texture(Picture picture) {
    TextureRef ref;
    ref.image = static_cast<uint32_t>(picture);
    return ref;
}

Material& material(Scene& scene, Surface surface) { return scene.materials[static_cast<size_t>(surface)]; }

/// A dielectric, or a metal when `metallic` is 1, in one colour.
void plain(Scene& scene, Surface surface, const char* name, glm::vec3 colour, float roughness, float metallic = 0) {
    Material& m = material(scene, surface);
    m.name = name;
    m.base_colour = {colour, 1};
    m.roughness = roughness;
    m.metallic = metallic;
}

void textured_ground(Scene& scene) {
    plain(scene, Surface::asphalt, "wet asphalt", glm::vec3(1), 1);
    Material& asphalt = material(scene, Surface::asphalt);
    asphalt.base_colour_texture = texture(Picture::asphalt_colour);
    asphalt.metallic_roughness_texture = texture(Picture::asphalt_surface);
    asphalt.normal_texture = texture(Picture::asphalt_normal);

    // Paint shows the stones below it: the asphalt's normal map, brought to its scale by a
    // transform because the two pictures repeat after different lengths.
    plain(scene, Surface::marking, "road marking", glm::vec3(1), 0.36f);
    Material& marking = material(scene, Surface::marking);
    marking.base_colour_texture = texture(Picture::marking);
    marking.normal_texture = texture(Picture::asphalt_normal);
    marking.normal_texture.uv_linear = glm::mat2(tile_metres(Surface::marking) / tile_metres(Surface::asphalt));
    marking.normal_scale = 0.5f;
    marking.alpha_mode = AlphaMode::mask;

    plain(scene, Surface::paving, "pavement", glm::vec3(1), 1);
    Material& paving = material(scene, Surface::paving);
    paving.base_colour_texture = texture(Picture::paving_colour);
    paving.metallic_roughness_texture = texture(Picture::paving_surface);
    paving.normal_texture = texture(Picture::paving_normal);
    plain(scene, Surface::kerb, "kerb", glm::vec3(0.24f, 0.23f, 0.22f), 0.38f);
    material(scene, Surface::kerb).normal_texture = texture(Picture::plaster_normal);
}

void walls(Scene& scene) {
    plain(scene, Surface::brick, "brick", glm::vec3(1), 0.72f);
    material(scene, Surface::brick).base_colour_texture = texture(Picture::brick_colour);
    material(scene, Surface::brick).normal_texture = texture(Picture::brick_normal);
    plain(scene, Surface::plaster, "plaster", glm::vec3(1), 0.8f);
    material(scene, Surface::plaster).normal_texture = texture(Picture::plaster_normal);
    plain(scene, Surface::trim, "stone trim", glm::vec3(1), 0.6f);
    plain(scene, Surface::frame, "window frame", glm::vec3(1), 0.4f);
    plain(scene, Surface::wood, "wood", glm::vec3(1), 0.5f);
    material(scene, Surface::wood).base_colour_texture = texture(Picture::wood);
    plain(scene, Surface::roofing, "roofing", glm::vec3(0.11f, 0.11f, 0.12f), 0.6f);
    plain(scene, Surface::fabric, "awning", glm::vec3(1), 0.9f);
    material(scene, Surface::fabric).base_colour_texture = texture(Picture::fabric);
}

void glowing(Scene& scene) {
    plain(scene, Surface::window, "windows", glm::vec3(0.02f), 0.12f);
    material(scene, Surface::window).emissive = glm::vec3(0.85f);
    material(scene, Surface::window).emissive_texture = texture(Picture::windows);
    plain(scene, Surface::shop, "shop windows", glm::vec3(0.02f), 0.12f);
    material(scene, Surface::shop).emissive = glm::vec3(1.1f);
    material(scene, Surface::shop).emissive_texture = texture(Picture::shops);
    plain(scene, Surface::glow, "glow", glm::vec3(0.03f), 0.3f);
    material(scene, Surface::glow).emissive = glm::vec3(3.0f);
    material(scene, Surface::glow).emissive_texture = texture(Picture::palette);
    plain(scene, Surface::sky, "night sky", glm::vec3(1), 1);
    material(scene, Surface::sky).unlit = true;
    material(scene, Surface::sky).base_colour_texture = texture(Picture::sky);
}

} // namespace

float tile_metres(Surface surface) {
    switch (surface) {
    case Surface::asphalt: return 12;
    case Surface::marking: return 3;
    case Surface::paving: return 2;
    case Surface::kerb: return 1.5f;
    case Surface::brick: return 2.4f;
    case Surface::plaster: return 3;
    case Surface::wood: return 0.8f;
    case Surface::fabric: return 0.5f;
    case Surface::leaves:
    case Surface::window:
    case Surface::shop:
    case Surface::glow:
    case Surface::sky: return 1; // their own rectangles
    default: return 0;
    }
}

bool has_normal_map(Surface surface) {
    return surface == Surface::asphalt || surface == Surface::marking || surface == Surface::paving ||
           surface == Surface::kerb || surface == Surface::brick || surface == Surface::plaster;
}

void add_materials(Scene& scene) {
    scene.materials.resize(static_cast<size_t>(Surface::count));
    textured_ground(scene);
    walls(scene);
    glowing(scene);
    plain(scene, Surface::metal, "painted metal", glm::vec3(0.035f, 0.04f, 0.042f), 0.38f);
    plain(scene, Surface::board, "sign board", glm::vec3(1), 0.35f);
    plain(scene, Surface::car_paint, "car paint", glm::vec3(1), 0.28f, 0.35f);
    plain(scene, Surface::car_glass, "car glass", glm::vec3(0.012f, 0.014f, 0.016f), 0.1f);
    plain(scene, Surface::rubber, "rubber", glm::vec3(0.016f), 0.7f);
    plain(scene, Surface::chrome, "chrome", glm::vec3(0.75f), 0.22f, 1);
    plain(scene, Surface::bark, "bark", glm::vec3(0.09f, 0.065f, 0.045f), 0.85f);
    plain(scene, Surface::leaves, "leaves", glm::vec3(1), 0.55f);
    Material& leaves = material(scene, Surface::leaves);
    leaves.base_colour_texture = texture(Picture::leaves);
    leaves.alpha_mode = AlphaMode::mask;
    leaves.double_sided = true;
    plain(scene, Surface::grating, "shutter", glm::vec3(0.28f, 0.29f, 0.3f), 0.42f, 0.7f);
}

} // namespace prelight::city
