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

} // namespace prelight::test
