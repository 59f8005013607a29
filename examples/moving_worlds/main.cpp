// What a frame of a moving world costs: a crowd of 10,000 objects of which 100 move, 100 skinned characters, and 65,536
// lights. Prints the table of docs/moving.md.
//
//     example_moving_worlds [CHARACTER.glb]
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <prelight/device.hpp>
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>
#include <prelight/scene_io.hpp>
#include <prelight/timeline.hpp>

using namespace prelight;

namespace {

constexpr uint32_t width = 640, height = 360, frames = 20;

Primitive box() {
    Primitive p;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.f, 1.f}) {
            const auto first = static_cast<uint32_t>(p.positions.size());
            for (int i = 0; i < 4; ++i) {
                glm::vec3 corner(0), normal(0);
                corner[axis] = normal[axis] = side;
                corner[(axis + 1) % 3] = i & 1 ? 1.f : -1.f;
                corner[(axis + 2) % 3] = i & 2 ? side : -side;
                p.positions.push_back(0.4f * corner);
                p.normals.push_back(normal);
            }
            for (const uint32_t i : {0u, 1u, 3u, 0u, 3u, 2u})
                p.indices.push_back(first + i);
        }
    return p;
}

/// A frame's figures, milliseconds and bytes; medians of `frames` frames. `steps`: what changing the world took.
void report(const char* what, const std::vector<Stats>& all, const std::vector<double>& steps) {
    const auto median = [&](auto value) {
        std::vector<double> samples;
        for (const Stats& stats : all)
            samples.push_back(value(stats));
        return spread(samples).median;
    };
    const auto host = [](const Stats& s) {
        return s.host_ms->lights.median + s.host_ms->culling.median + s.host_ms->objects.median +
               s.host_ms->record.median;
    };
    fmt::print("| {} | {:.2f} | {:.2f} | {:.1f} | {:.0f} | {:.0f} | {} |\n", what, spread(steps).median, median(host),
               median([](const Stats& s) { return s.gpu_ms.median; }),
               median([](const Stats& s) { return double(s.updated_bytes); }) / 1024,
               median([](const Stats& s) { return double(s.frame_bytes); }) / 1024,
               all.back().created == CreatedObjects{} ? "nothing" : "something");
}

/// Draws `frames` frames, each after a step of the world, and two before them that do not count.
template <class Step>
void measure(const char* what, Renderer& renderer, const PlacedCamera& camera, Step step) {
    std::vector<Stats> all;
    std::vector<double> steps;
    for (uint32_t f = 0; f < frames + 2; ++f) {
        const auto start = std::chrono::steady_clock::now();
        step(f);
        const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
        renderer.render(camera);
        if (f < 2)
            continue;
        steps.push_back(taken.count());
        all.push_back(renderer.stats());
    }
    report(what, all, steps);
}

void crowd(Device& device) {
    Scene scene;
    scene.name = "crowd";
    scene.materials.emplace_back();
    scene.meshes.push_back({"box", {box()}});
    World world{.scene = &scene};
    for (int i = 0; i < 10000; ++i)
        world.instances.push_back({.transform = glm::translate(glm::dmat4(1), {i % 100, 0, i / 100})});
    world.ambient = glm::vec3(0.3f);
    const PlacedCamera camera = look_at({.yfov = 1}, {-10, 30, -10}, {50, 0, 50});
    const auto renderer = create_renderer("light-prepass", &device,
                                          {.width = width, .height = height, .settings = {{"index-trimming", "off"}}});
    renderer->set_world(world);
    measure("10,000 objects, none moves", *renderer, camera, [](uint32_t) {});
    measure("10,000 objects, 100 move", *renderer, camera, [&](uint32_t f) {
        WorldChanges changes;
        for (uint32_t i = 0; i < 100; ++i) {
            const uint32_t moved = 100 * i + 50;
            world.instances[moved].transform[3].y = std::sin(0.2 * f + i);
            changes.instances.push_back(moved);
        }
        renderer->update_world(changes);
    });
    measure("10,000 objects, all move", *renderer, camera, [&](uint32_t f) {
        WorldChanges changes;
        for (uint32_t i = 0; i < 10000; ++i) {
            world.instances[i].transform[3].y = std::sin(0.2 * f + i);
            changes.instances.push_back(i);
        }
        renderer->update_world(changes);
    });
}

/// The file's first scene `count` times side by side, each copy with skins and animations of its own.
Scene copies(const Scene& one, uint32_t count) {
    Scene all = one;
    all.nodes.clear();
    all.skins.clear();
    all.animations = {{"all", {}, {}}};
    all.scenes = {{"copies", {}}};
    all.default_scene = 0;
    for (uint32_t c = 0; c < count; ++c) {
        const auto first_node = static_cast<uint32_t>(all.nodes.size());
        const auto first_skin = static_cast<uint32_t>(all.skins.size());
        for (Node node : one.nodes) {
            for (uint32_t& child : node.children)
                child += first_node;
            if (node.skin)
                *node.skin += first_skin;
            all.nodes.push_back(node);
        }
        for (Skin skin : one.skins) {
            for (uint32_t& joint : skin.joints)
                joint += first_node;
            all.skins.push_back(skin);
        }
        for (const Animation& animation : one.animations) {
            const auto first_sampler = static_cast<uint32_t>(all.animations[0].samplers.size());
            all.animations[0].samplers.insert(all.animations[0].samplers.end(), animation.samplers.begin(),
                                              animation.samplers.end());
            for (AnimationChannel channel : animation.channels) {
                channel.sampler += first_sampler;
                channel.node += first_node;
                all.animations[0].channels.push_back(channel);
            }
        }
        Node root{.name = "place", .local = glm::translate(glm::dmat4(1), {1.5 * (c % 10), 0, 1.5 * (c / 10)})};
        for (const uint32_t node : one.scenes[one.default_scene].nodes)
            root.children.push_back(first_node + node);
        all.scenes[0].nodes.push_back(static_cast<uint32_t>(all.nodes.size()));
        all.nodes.push_back(root);
    }
    return all;
}

void characters(Device& device, const char* file, uint32_t count) {
    const Scene scene = copies(load_gltf(file), count);
    Timeline timeline(scene, {}, Moment{0}, {}, false);
    const PlacedCamera camera =
        count == 1 ? look_at({.yfov = 1}, {0, 1, 3}, {0, 1, 0}) : look_at({.yfov = 1}, {-4, 6, 20}, {7, 0, 7});
    const auto renderer = create_renderer("light-prepass", &device,
                                          {.width = width, .height = height, .settings = {{"index-trimming", "off"}}});
    renderer->set_world(timeline.world());
    measure(fmt::format("{} characters, still", count).c_str(), *renderer, camera, [](uint32_t) {});
    measure(fmt::format("{} characters, walking", count).c_str(), *renderer, camera,
            [&](uint32_t f) { renderer->update_world(timeline.move_to({f / 30.0})); });
}

void lights(Device& device) {
    const Scene scene = make_scene("lights", 65536, 1);
    World world = resolve(scene);
    const auto renderer = create_renderer("light-prepass", &device,
                                          {.width = width, .height = height, .settings = {{"index-trimming", "off"}}});
    renderer->set_world(world);
    measure("65,536 lights, still", *renderer, world.cameras[0], [](uint32_t) {});
    PlacedCamera camera = world.cameras[0];
    measure("65,536 lights, the camera moves", *renderer, camera, [&](uint32_t) { camera.position.y += 0.01; });
    measure("65,536 lights, all move", *renderer, world.cameras[0], [&](uint32_t f) {
        for (size_t i = 0; i < world.lights.size(); ++i)
            world.lights[i].position.y += 0.01 * std::sin(0.3 * f + double(i));
        renderer->update_world({.lights = true});
    });
}

} // namespace

int main(int argc, char** argv) {
    try {
        const auto device = Device::create({});
        fmt::print("{}, {}x{}\n\n| world | change ms | frame ms, host | frame ms, device | updated KiB | of the frame "
                   "KiB | made |\n"
                   "| --- | --- | --- | --- | --- | --- | --- |\n",
                   device->name(), width, height);
        crowd(*device);
        for (const uint32_t count : {1u, 100u})
            if (argc > 1)
                characters(*device, argv[1], count);
        lights(*device);
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
