#pragma once
#include "garden.hpp"
#include "random_scene.hpp"
#include <cmath>
#include <glm/geometric.hpp>
#include <prelight/light_distribution.hpp>
#include <scene/procedural/random.hpp>

namespace prelight {

/// A floor with spheres, boxes and a card with holes on it, under lights of every kind.
class Stage : public TestWorld {
public:
    explicit Stage(uint64_t seed) : random_(seed) {
        scene.images = {small_map("spot", 16, 16), small_map("point", 48, 8)};
        add(square(6), glm::rotate(glm::dmat4(1), -1.5707963267948966, {1, 0, 0}));
        add(sphere(16), thing());
        add(cube(), thing());
        const uint32_t holes =
            add_image(4, 1, {255, 255, 255, 255, 255, 255, 255, 0, 255, 255, 255, 255, 255, 255, 255, 0});
        Material card{.name = "card", .double_sided = true};
        card.alpha_mode = AlphaMode::mask;
        card.base_colour_texture = {.image = holes};
        add_material(card);
        add(square(0.8f), thing());
        for (int i = 0; i < 4; ++i)
            place(1 + random_.below(3), thing());
        for (const LightKind kind :
             {LightKind::directional, LightKind::point, LightKind::spot, LightKind::spot, LightKind::point})
            world.lights.push_back(some_light(kind));
        world.ambient = glm::vec3(0.02f);
        look();
    }

    PlacedCamera camera;

    /// One to three changes of lights, and sometimes of the camera or (true) of the objects.
    bool change() {
        for (uint32_t n = 1 + random_.below(3); n > 0; --n)
            change_light();
        if (random_.below(3) == 0)
            look();
        const bool objects = random_.below(5) == 0;
        if (objects)
            change_object();
        return objects;
    }

    /// Something of the world, changed where it stands: what is told with update_world().
    WorldChanges change_in_place() {
        WorldChanges changes;
        for (uint32_t n = 1 + random_.below(3); n > 0; --n)
            change_in_place(changes);
        if (random_.below(3) == 0)
            look();
        return changes;
    }

private:
    /// Of few texels: each new renderer makes levels of them.
    TextureImage small_map(const char* name, uint32_t width, uint32_t height) {
        TextureImage image{name, width, height, {}};
        for (uint32_t i = 0; i < width * height; ++i) {
            const auto code = static_cast<uint8_t>((i % width / 3 + i / width / 2) % 2 ? 230 : 40 + i % 30);
            image.rgba.insert(image.rgba.end(), {code, static_cast<uint8_t>(code / 2 + i % width), code, 255});
        }
        return image;
    }
    void change_in_place(WorldChanges& changes) {
        const uint32_t which = 1 + random_.below(static_cast<uint32_t>(world.instances.size() - 1));
        Instance& instance = world.instances[which];
        const uint32_t m = random_.below(static_cast<uint32_t>(scene.materials.size()));
        Material& material = scene.materials[m];
        switch (random_.below(13)) {
        case 0: instance.visible = !instance.visible; break;
        case 1:
            instance.transform = glm::translate(glm::dmat4(1), {0, number(2, 5), 0}) * thing();
            break; // out of the box
        case 2:    // seen in a mirror: other front faces
            instance.transform = glm::scale(instance.transform, glm::dvec3(-1, 1, 1));
            instance.mirrored = !instance.mirrored;
            break;
        case 3:
            instance.previous_transform = instance.transform;
            instance.transform = thing();
            instance.mirrored = false;
            break;
        case 4:
            change_light();
            changes.lights = true;
            return;
        case 5:
            material.base_colour = glm::vec4(number(0, 1), number(0, 1), number(0, 1), material.base_colour.a);
            material.roughness = static_cast<float>(number(0.1, 1));
            material.metallic = static_cast<float>(random_.below(2));
            changes.materials.push_back(m);
            return;
        case 9:
            material.alpha_cutoff = static_cast<float>(number(0.1, 0.9));
            material.base_colour.a = static_cast<float>(number(0.3, 1));
            changes.materials.push_back(m);
            return;
        case 6:
            material.emissive = glm::vec3(static_cast<float>(number(0, 0.3)));
            changes.materials.push_back(m);
            return;
        case 7:
            if (random_.below(4) == 0) // other pipelines
                material.unlit = !material.unlit;
            changes.materials.push_back(m);
            return;
        case 8:
            for (PlacedDecal& placed : world.decals)
                placed.transform = glm::translate(glm::dmat4(1), {number(-2, 2), 0, number(-2, 2)}) * placed.transform;
            changes.decals = true;
            return;
        default: instance.transform = thing(); instance.mirrored = false;
        }
        changes.instances.push_back(which);
    }
    double number(double low, double high) { return random_.uniform(low, high); }
    glm::dvec3 direction() { return glm::normalize(glm::dvec3(number(-1, 1), number(-1.5, -0.1), number(-1, 1))); }
    glm::dmat4 thing() {
        const glm::dmat4 m = glm::translate(glm::dmat4(1), {number(-3, 3), number(0.2, 1.6), number(-3, 3)});
        return glm::scale(glm::rotate(m, number(0, 6.28), glm::normalize(glm::dvec3(number(-1, 1), 1, number(-1, 1)))),
                          glm::dvec3(number(0.3, 0.8)));
    }
    PlacedLight some_light(LightKind kind) {
        PlacedLight out{
            {.kind = kind, .colour = hue_colour(number(0, 1), 0.5), .intensity = static_cast<float>(number(1, 6))}};
        out.position = {number(-4, 4), number(0.8, 4), number(-4, 4)};
        out.direction = direction();
        out.light.range = static_cast<float>(number(2, 9));
        set_cone(out.light);
        repair(out.light);
        return out;
    }
    void set_cone(Light& light) {
        light.outer_cone = static_cast<float>(number(0.1, 1.45));
        light.inner_cone = light.outer_cone * static_cast<float>(number(0, 0.9));
    }
    /// What a light may have goes by its kind.
    static void repair(Light& light) {
        if (light.kind == LightKind::directional) {
            light.profile = nullptr;
            light.cookie = no_cookie;
            light.falloff = Falloff::gltf;
        } else if (light.cookie != no_cookie) {
            light.cookie = light.kind == LightKind::spot ? 0 : 1;
        }
        if (!std::isfinite(light.range))
            light.falloff = Falloff::gltf;
    }
    void change_light() {
        std::vector<PlacedLight>& lights = world.lights;
        if (lights.empty()) {
            lights.push_back(some_light(LightKind::point));
            return;
        }
        PlacedLight& placed = lights[random_.below(static_cast<uint32_t>(lights.size()))];
        Light& light = placed.light;
        const uint32_t other = random_.below(static_cast<uint32_t>(lights.size()));
        switch (random_.below(20)) {
        case 0: placed.position = {number(-4, 4), number(0.8, 4), number(-4, 4)}; break;
        case 1: placed.position += glm::dvec3(number(-0.1, 0.1), 0, number(-0.1, 0.1)); break;
        case 2:
        case 3: placed.direction = direction(); break;
        case 4: placed.direction = glm::normalize(placed.direction + 0.2 * direction()); break;
        case 5: set_cone(light); break;
        case 6: light.range = static_cast<float>(number(0.8, 9)); break;
        case 7: light.range = std::numeric_limits<float>::infinity(); break;
        case 8: light.kind = static_cast<LightKind>(random_.below(3)); break;
        case 9: light.intensity = random_.below(3) ? static_cast<float>(number(0.5, 8)) : 0; break;
        case 10: lights.push_back(some_light(static_cast<LightKind>(random_.below(3)))); return;
        case 11: lights.erase(lights.begin() + other); return;
        case 12: std::swap(placed, lights[other]); return;
        case 13: light.casts_shadow = !light.casts_shadow; break;
        case 14: light.cookie = light.cookie == no_cookie ? 0 : no_cookie; break;
        case 15: light.profile = light.profile ? nullptr : wall_lamp(); break;
        case 16: light.falloff = static_cast<Falloff>(random_.below(3)); break;
        case 17: light.size = static_cast<float>(number(0.01, 0.3)); break;
        case 18: placed.up = glm::normalize(glm::dvec3(number(-1, 1), number(-1, 1), 1)); break;
        default:
            for (PlacedLight& each : lights)
                each.light.range *= static_cast<float>(number(0.5, 2));
        }
        repair(light);
    }
    void change_object() {
        std::vector<Instance>& all = world.instances; // the first is the floor
        const uint32_t which = 1 + random_.below(static_cast<uint32_t>(all.size() - 1));
        switch (all.size() > 3 ? random_.below(3) : random_.below(2)) {
        case 0: all[which].transform = thing(); break;
        case 1: place(1 + random_.below(3), thing()); break;
        default: all.erase(all.begin() + which);
        }
    }
    void look() {
        Camera lens{.yfov = number(0.5, 1.2), .znear = 0.05};
        if (random_.below(3) == 0)
            lens = {.kind = ProjectionKind::orthographic, .ymag = number(2, 4), .znear = 0, .zfar = 30};
        const double turn = number(0, 6.28);
        camera =
            look_at(lens, {6 * std::cos(turn), number(2, 5), 6 * std::sin(turn)}, {number(-1, 1), 0, number(-1, 1)});
    }

    Random random_;
};

} // namespace prelight
