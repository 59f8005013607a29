// `prelight compare` exchanges the lights of a built-in scene and keeps the rest on the device. In these
// scenes that is what making them anew would give; `motion` has a lamp for each light.
#include <gtest/gtest.h>
#include <prelight/scene_io.hpp>

namespace prelight {
namespace {

TEST(BuiltinScenes, GeometryDoesNotDependOnTheNumberOfLights) {
    for (const char* name : {"city", "lights", "spheres", "glass"}) {
        SCOPED_TRACE(name);
        const Scene few = make_scene(name, 5, 1), many = make_scene(name, 700, 1);
        ASSERT_EQ(few.meshes.size(), many.meshes.size());
        for (size_t m = 0; m < few.meshes.size(); ++m) {
            ASSERT_EQ(few.meshes[m].primitives.size(), many.meshes[m].primitives.size());
            for (size_t p = 0; p < few.meshes[m].primitives.size(); ++p) {
                EXPECT_TRUE(few.meshes[m].primitives[p].positions == many.meshes[m].primitives[p].positions);
                EXPECT_EQ(few.meshes[m].primitives[p].material, many.meshes[m].primitives[p].material);
            }
        }
        ASSERT_EQ(few.materials.size(), many.materials.size());
        for (size_t m = 0; m < few.materials.size(); ++m) {
            EXPECT_EQ(few.materials[m].base_colour, many.materials[m].base_colour);
            EXPECT_EQ(few.materials[m].emissive, many.materials[m].emissive);
        }
        const World a = resolve(few), b = resolve(many);
        ASSERT_EQ(a.instances.size(), b.instances.size());
        for (size_t i = 0; i < a.instances.size(); ++i) {
            EXPECT_EQ(a.instances[i].mesh, b.instances[i].mesh);
            EXPECT_TRUE(a.instances[i].transform == b.instances[i].transform) << "instance " << i;
        }
        EXPECT_EQ(a.ambient, b.ambient);
    }
}

} // namespace
} // namespace prelight
