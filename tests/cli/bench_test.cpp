// `prelight bench`: the table on stdout, the same figures in the file.
#include "process.hpp"

#include <fstream>
#include <gmock/gmock.h>
#include <map>
#include <nlohmann/json.hpp>

namespace prelight::test {
namespace {

using testing::HasSubstr;

TEST(BenchEncodings, PrintsATableAndWritesIt) {
    const TemporaryFolder folder;
    const Result result = run(
        {"bench", "encodings", "--size", "64x36", "--lights", "4", "--device", "cpu", "--validate", "--json", "e.json"},
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
                                {{"VK_DRIVER_FILES", "/nonexistent.json"}, {"VK_ICD_FILENAMES", "/nonexistent.json"}}),
                            1));
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(BenchLightBuffers, PrintsATableAndWritesIt) {
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

TEST(BenchClaims, PrintsEachClaimAndWritesIt) {
    const TemporaryFolder folder;
    const Result result = run({"bench", "claims", "--size", "64x36", "--lights", "8", "--frames", "1", "--device",
                               "cpu", "--validate", "--json", "c.json"},
                              folder.path);
    ASSERT_TRUE(succeeded(result));
    EXPECT_THAT(result.out, HasSubstr("spheres, 8 lights"));
    std::ifstream file(folder.path / "c.json");
    const nlohmann::json json = nlohmann::json::parse(file);
    EXPECT_EQ(json["size"], nlohmann::json({64, 36}));
    EXPECT_EQ(json["frames"], 1);
    std::map<std::string, nlohmann::json> claims;
    for (const nlohmann::json& row : json["claims"]) {
        claims[row["id"]] = row;
        EXPECT_THAT(result.out,
                    HasSubstr("\n" + row["id"].get<std::string>() + ": " + row["verdict"].get<std::string>() + "\n"));
        EXPECT_NE(row["source"], "");
        EXPECT_EQ(row["ratio"].is_null(), row["verdict"] == "not measured");
    }
    ASSERT_EQ(claims.size(), 19u);
    // Sizes are exact; an allocation may round a small picture up, but both of a difference alike.
    EXPECT_DOUBLE_EQ(claims["msaa-target"]["a"], 7.3728);
    EXPECT_DOUBLE_EQ(claims["five-targets"]["a"], 36.864);
    EXPECT_DOUBLE_EQ(claims["no-msaa-light-buffers"]["a"], 7.3728);
    EXPECT_NEAR(claims["no-specular-buffer"]["a"], 3.6864, 0.5);
    for (const char* id : {"msaa-target", "five-targets", "no-msaa-light-buffers"})
        EXPECT_EQ(claims[id]["verdict"], "agrees");
    // Times: a null in JSON is what a figure that is not finite becomes.
    for (const char* id :
         {"depth-against-ambient", "depth-against-normals", "frustum-ray", "ambient-first", "conditional-rendering",
          "index-trimming", "vertices-culled", "inferred-lighting", "shadowed-directional-1", "shadowed-directional-2",
          "shadowed-directional-4", "shadowed-directional-8", "more-directionals"}) {
        EXPECT_GT(claims[id]["a"], 0) << id;
        EXPECT_GT(claims[id]["b"], 0) << id;
        EXPECT_GT(claims[id]["ratio"], 0) << id;
    }
    for (const char* id : {"multipass-lights", "multipass-geometry"}) {
        EXPECT_TRUE(claims[id]["a"].is_number()) << id;
        EXPECT_TRUE(claims[id]["b"].is_number()) << id;
    }
    ASSERT_EQ(json["presets"].size(), 3u);
    for (const nlohmann::json& row : json["presets"]) {
        EXPECT_GE(row["bytes_per_pixel"], 12) << row;
        EXPECT_GE(row["bytes_per_pixel_unshared"], row["bytes_per_pixel"]) << row;
    }
}

TEST(BenchClaims, InventsNoFigureForOneLight) {
    const TemporaryFolder folder;
    ASSERT_TRUE(succeeded(run(
        {"bench", "claims", "--size", "16x9", "--lights", "1", "--frames", "1", "--device", "cpu", "--json", "c.json"},
        folder.path)));
    std::ifstream file(folder.path / "c.json");
    for (const nlohmann::json& row : nlohmann::json::parse(file)["claims"])
        if (row["id"] == "multipass-lights" || row["id"] == "multipass-geometry") {
            EXPECT_TRUE(row["a"].is_null()) << row;
            EXPECT_EQ(row["verdict"], "not measured") << row;
        }
}

} // namespace
} // namespace prelight::test
