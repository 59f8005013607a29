// `prelight bench`: the table on stdout, the same figures in the file.
#include "process.hpp"

#include <fstream>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace prelight::test {
namespace {

using testing::HasSubstr;

TEST(BenchEncodings, L1_PrintsATableAndWritesIt) {
    const TemporaryFolder folder;
    const Result result = run({"bench", "encodings", "--size", "64x36", "--lights", "4", "--device", "cpu",
                               "--validate", "--json", "e.json"},
                              folder.path);
    ASSERT_TRUE(succeeded(result));
    EXPECT_THAT(result.out, HasSubstr("spheres, 4 lights, 64x36"));
    std::ifstream file(folder.path / "e.json");
    const nlohmann::json json = nlohmann::json::parse(file);
    EXPECT_EQ(json["bench"], "encodings");
    EXPECT_EQ(json["scene"], "spheres");
    EXPECT_EQ(json["size"], nlohmann::json({64, 36}));
    EXPECT_EQ(json["lights"], 4);
    EXPECT_GE(json["directions"], 2'000'000);
    EXPECT_NE(json["device"], "");
    ASSERT_EQ(json["encodings"].size(), 7u);
    for (const nlohmann::json& row : json["encodings"]) {
        EXPECT_THAT(result.out, HasSubstr("\n" + row["name"].get<std::string>() + " "));
        EXPECT_GE(row["bits"], 16);
        EXPECT_GE(row["bytes_per_pixel"], 4);
        EXPECT_LT(0, row["mean_degrees"]);
        EXPECT_LT(row["mean_degrees"], row["percentile_99_degrees"]);
        EXPECT_LT(row["percentile_99_degrees"], row["max_degrees"]);
        EXPECT_LT(row["max_degrees"], 1);
        EXPECT_GT(row["psnr_db"], 40);
    }
    ASSERT_EQ(json["depth_sources"].size(), 4u);
    for (const nlohmann::json& row : json["depth_sources"]) {
        EXPECT_THAT(result.out, HasSubstr("\n" + row["name"].get<std::string>() + " "));
        EXPECT_GT(row["psnr_db"], 40);
    }
    EXPECT_TRUE(json["depth_sources"][0]["max_relative_error"].is_null());
    EXPECT_EQ(json["depth_sources"][1]["max_relative_error"], 0);
}

TEST(BenchEncodings, RefusesInOneLine) {
    const TemporaryFolder folder;
    EXPECT_TRUE(failed_with(run({"bench", "encodings", "--json", "missing/e.json"}, folder.path), 1));
    EXPECT_TRUE(failed_with(run({"bench", "encodings", "--scene", "missing.glb"}, folder.path), 1));
    EXPECT_TRUE(failed_with(run({"bench", "encodings", "--json", "e.json"}, folder.path, {},
                                {{"VK_DRIVER_FILES", "/nonexistent.json"}, {"VK_ICD_FILENAMES", "/nonexistent.json"}}), 1));
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(BenchLightBuffers, L4_L5_PrintsATableAndWritesIt) {
    const TemporaryFolder folder;
    const Result result =
        run({"bench", "light-buffers", "--size", "16x9", "--device", "cpu", "--json", "l.json"}, folder.path);
    ASSERT_TRUE(succeeded(result));
    std::ifstream file(folder.path / "l.json");
    const nlohmann::json json = nlohmann::json::parse(file);
    EXPECT_EQ(json["bench"], "light-buffers");
    EXPECT_EQ(json["size"], nlohmann::json({16, 9}));
    ASSERT_EQ(json["light_buffers"].size(), 4u * 28);
    for (const nlohmann::json& row : json["light_buffers"]) {
        EXPECT_THAT(result.out, HasSubstr("\n" + row["name"].get<std::string>() + " "));
        EXPECT_LT(row["diffuse_error"]["rms"], row["diffuse_error"]["max"]);
        EXPECT_LT(0, row["specular_error"]["rms"]);
        EXPECT_LT(0, row["overlap"]);
    }
}

} // namespace
} // namespace prelight::test
