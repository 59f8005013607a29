// One world on the device for several renderers: Renderer::share_world().
#include "garden.hpp"
#include "vulkan_calls.hpp"
#include <prelight/error.hpp>

namespace prelight {
namespace {

struct SharedGarden : Garden {
    SharedGarden() { add_lights(20, 3, 4); }
    std::unique_ptr<Renderer> renderer(const RenderOptions& options, const char* name = "light-prepass") const {
        return create_renderer(name, &test_device(), options);
    }
    Image picture(Renderer& drawn) const {
        drawn.render(camera);
        return drawn.read("final");
    }
    Image fresh(const RenderOptions& options, const char* name = "light-prepass") const {
        const auto made = renderer(options, name);
        made->set_world(world);
        return picture(*made);
    }
};

const RenderOptions full_picture_options{.width = 96, .height = 54};
const RenderOptions small_picture_options{.width = 50, .height = 40, .settings = {{"light-culling", "volumes"}}};

TEST(SharedWorld, IsUploadedOnce) {
    const SharedGarden garden;
    const auto first = garden.renderer(full_picture_options), second = garden.renderer(small_picture_options),
               third = garden.renderer(full_picture_options, "z-prepass");
    first->set_world(garden.world);
    const auto buffers = [](auto&& work) {
        const VulkanCalls calls;
        work();
        return calls.buffers;
    };
    const uint64_t own = buffers([&] { second->set_world(garden.world); });
    const uint64_t shared = buffers([&] { second->share_world(*first); });
    EXPECT_LT(shared + 3, own) << "vertices, attributes and indices at least";
    third->share_world(*second);
    EXPECT_EQ(third->world(), &garden.world);
    EXPECT_EQ(garden.picture(*second).pixels, garden.fresh(small_picture_options).pixels);
    EXPECT_EQ(garden.picture(*first).pixels, garden.fresh(full_picture_options).pixels);
    EXPECT_EQ(garden.picture(*third).pixels, garden.fresh(full_picture_options, "z-prepass").pixels);
    expect_validation_clean(test_device());
}

TEST(SharedWorld, ChangesForAll) {
    SharedGarden garden;
    const auto first = garden.renderer(full_picture_options), second = garden.renderer(small_picture_options);
    first->set_world(garden.world);
    second->share_world(*first);
    for (int step = 0; step < 6; ++step) {
        SCOPED_TRACE(step);
        garden.world.instances[1].transform[3] += glm::dvec4(0.2, 0.1, 0, 0);
        garden.scene.materials[garden.scene.meshes[garden.world.instances[1].mesh].primitives[0].material]
            .base_colour.r = 0.1f * float(step);
        WorldChanges changes;
        changes.instances = {1};
        changes.materials = {garden.scene.meshes[garden.world.instances[1].mesh].primitives[0].material};
        first->update_world(changes);
        second->update_world(changes);
        first->render(garden.camera); // several in flight
        second->render(garden.camera);
        if (step == 2)
            garden.camera.position.y += 0.3;
        EXPECT_EQ(garden.picture(*second).pixels, garden.fresh(small_picture_options).pixels);
        EXPECT_EQ(garden.picture(*first).pixels, garden.fresh(full_picture_options).pixels);
    }
    expect_validation_clean(test_device());
}

TEST(SharedWorld, OutlivesWhoUploadedIt) {
    const SharedGarden garden;
    auto first = garden.renderer(full_picture_options);
    const auto second = garden.renderer(small_picture_options);
    first->set_world(garden.world);
    second->share_world(*first);
    first->render(garden.camera);
    first.reset();
    EXPECT_EQ(garden.picture(*second).pixels, garden.fresh(small_picture_options).pixels);
    expect_validation_clean(test_device());
}

TEST(SharedWorld, IsCopiedWhereItHasToBeAnother) {
    const SharedGarden garden;
    RenderOptions bright = full_picture_options;
    bright.exposure = 2;
    const auto first = garden.renderer(full_picture_options), second = garden.renderer(bright),
               third = garden.renderer(full_picture_options, "deferred");
    EXPECT_THROW(second->share_world(*first), Error) << "there is no world";
    first->set_world(garden.world);
    second->share_world(*first);
    third->share_world(*first);
    EXPECT_EQ(garden.picture(*second).pixels, garden.fresh(bright).pixels);
    EXPECT_EQ(garden.picture(*third).pixels, garden.fresh(full_picture_options, "deferred").pixels);
    EXPECT_EQ(garden.picture(*first).pixels, garden.fresh(full_picture_options).pixels);
    const auto reference = create_renderer("reference", nullptr, {.width = 8, .height = 4});
    reference->share_world(*first);
    reference->render(garden.camera);
    EXPECT_EQ(reference->world(), &garden.world);
    expect_validation_clean(test_device());
}

} // namespace
} // namespace prelight
