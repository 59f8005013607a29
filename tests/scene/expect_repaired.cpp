// Apart from the builder, which writes the fuzzer's seeds without GoogleTest.
#include "gltf_builder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace prelight::test {

Scene expect_repaired(const GltfBuilder& builder, const std::string& warning) {
    EXPECT_EQ(error_of(builder), "");
    EXPECT_THAT(strict_error_of(builder), testing::StartsWith("test.glb: " + warning));
    Scene scene = builder.load();
    EXPECT_THAT(scene.warnings, testing::Contains(testing::StartsWith("test.glb: " + warning)));
    return scene;
}

void expect_told(GltfBuilder good, const Damage& damage) {
    ASSERT_EQ(error_of(good), "");
    damage.change(good);
    if (damage.repaired) {
        expect_repaired(good, damage.line);
        return;
    }
    const std::string line = error_of(good);
    EXPECT_THAT(line, testing::StartsWith("test.glb: " + damage.line));
    EXPECT_EQ(line.find('\n'), std::string::npos);
}

} // namespace prelight::test
