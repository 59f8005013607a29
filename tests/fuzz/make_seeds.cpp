#include "pictures.hpp"
#include <cstdio>
#include <fstream>

// fuzz_seeds FOLDER: writes one small valid file for each part of each reader, in a folder for each target.

using namespace prelight::test;

namespace {

GltfBuilder with_texture(const Bytes& picture) {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.add_image(picture);
    b.json["textures"] = Json::array({{{"source", 0}, {"sampler", 0}}});
    b.json["samplers"] = Json::array({{{"wrapS", 33071}, {"wrapT", 33648}, {"minFilter", 9985}}});
    b.json["materials"][0] = {
        {"normalTexture", {{"index", 0}, {"scale", 0.5}}},
        {"alphaMode", "MASK"},
        {"pbrMetallicRoughness",
         {{"baseColorTexture",
           {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"rotation", 1}, {"offset", {0, 1}}}}}}}}}}};
    return b;
}

GltfBuilder with_sparse() {
    GltfBuilder b = GltfBuilder::triangle();
    const size_t places = b.add_view({1});
    const size_t values = b.add_view(bytes_of<float>({5, 6, 7}));
    b.json["accessors"][0]["sparse"] = {{"count", 1},
                                        {"indices", {{"bufferView", places}, {"componentType", 5121}}},
                                        {"values", {{"bufferView", values}}}};
    b.primitive()["indices"] = b.add_values<uint8_t>({0, 1, 2, 1, 0}, 5121, "SCALAR");
    b.primitive()["mode"] = 5;
    return b;
}

GltfBuilder with_nodes() {
    GltfBuilder b = GltfBuilder::triangle();
    b.json["cameras"] =
        Json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}},
                     {{"type", "orthographic"}, {"orthographic", {{"ymag", 2}, {"znear", 0}, {"zfar", 9}}}}});
    b.json["extensions"]["KHR_lights_punctual"]["lights"] =
        Json::array({{{"type", "spot"}, {"spot", {{"outerConeAngle", 0.4}}}}, {{"type", "point"}, {"range", 5}}});
    b.json["nodes"] = Json::array({{{"mesh", 0}, {"children", {1, 2}}, {"scale", {1, -1, 2}}},
                                   {{"camera", 0}, {"rotation", {0, 0, 1, 0}}},
                                   {{"camera", 1}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}});
    const size_t t = b.add_floats({1, 2, 3, 4, 5, 6}, "VEC3");
    b.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = t;
    return b;
}

GltfBuilder with_animation() {
    GltfBuilder b = GltfBuilder::textured_triangle();
    b.attributes()["JOINTS_0"] = b.add_values<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, 5121, "VEC4");
    b.attributes()["WEIGHTS_0"] = b.add_floats({1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0}, "VEC4");
    b.primitive()["targets"] = {{{"POSITION", b.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3")}}};
    b.json["meshes"][0]["weights"] = {0.5};
    b.json["nodes"] = {{{"mesh", 0}, {"skin", 0}}, {{"children", {2}}}, {{"translation", {1, 0, 0}}}};
    b.json["scenes"][0]["nodes"] = {0, 1};
    b.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", b.add_floats(std::vector<float>(32, 0), "MAT4")}}};
    for (size_t i = 15; i < 32; i += 16)
        std::memcpy(b.binary.data() + b.binary.size() - 128 + 4 * i, "\0\0\x80\x3f", 4); // w = 1
    const size_t times = b.add_floats({0, 1}, "SCALAR");
    b.json["animations"] = {
        {{"samplers",
          {{{"input", times}, {"output", b.add_floats({1, 0, 0, 1, 2, 0}, "VEC3")}},
           {{"input", times}, {"output", b.add_floats({0, 0, 0, 1, 0, 0, 1, 0}, "VEC4")}, {"interpolation", "STEP"}},
           {{"input", times},
            {"output", b.add_floats({0, 0, 0, 0, 1, 0}, "SCALAR")},
            {"interpolation", "CUBICSPLINE"}}}},
         {"channels",
          {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}},
           {{"sampler", 1}, {"target", {{"node", 1}, {"path", "rotation"}}}},
           {{"sampler", 2}, {"target", {{"node", 0}, {"path", "weights"}}}}}}}};
    return b;
}

GltfBuilder with_cookie() {
    GltfBuilder b = GltfBuilder::triangle();
    b.add_image(png(2, 1, solid(2, 1, {9, 99, 200, 255})));
    b.json["textures"] = Json::array({{{"source", 0}}});
    const std::string ies = "TILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 1 0\n0 90\n0\n400 100\n";
    b.json["extensions"]["KHR_lights_punctual"]["lights"] =
        Json::array({{{"type", "point"},
                      {"extras",
                       {{"prelight",
                         {{"cookie", {{"texture", {{"index", 0}}}}},
                          {"size", 0.1},
                          {"ies", {{"bufferView", b.add_view({ies.begin(), ies.end()})}}}}}}}}});
    b.json["nodes"][0]["extensions"]["KHR_lights_punctual"] = {{"light", 0}};
    return b;
}

/// Each kind of picture that decoders treat differently.
std::vector<std::pair<std::string, Bytes>> pictures() {
    using Stored = JpegForm::Stored;
    const Bytes rgba = solid(9, 9, {200, 100, 50, 128}), rgb = solid(9, 9, {200, 100, 50}), grey(81, 77);
    std::vector<std::pair<std::string, Bytes>> all{
        {"rgba.png", png(9, 9, rgba)},
        {"palette.png", RawPng{.width = 4,
                               .bits = 2,
                               .colour = 3,
                               .chunks = {{"PLTE", {1, 2, 3, 4, 5, 6}}, {"tRNS", {7}}},
                               .lines = {0, 0x1b}}
                            .bytes()},
        {"wide.png",
         RawPng{.width = 2, .bits = 16, .colour = 2, .chunks = {{"tRNS", Bytes(6, 1)}}, .lines = Bytes(13, 1)}.bytes()},
        {"interlaced.png",
         RawPng{.width = 3, .height = 3, .colour = 0, .interlaced = true, .lines = Bytes(15, 0)}.bytes()},
        {"lossless.webp", webp_lossless(9, 9, rgba)},
        {"lossy.webp", webp_lossy(9, 9, rgba)},
    };
    for (const auto& [name, form] : {std::pair("baseline", JpegForm{}),
                                     {"progressive", JpegForm{.progressive = true}},
                                     {"arithmetic", JpegForm{.arithmetic = true}},
                                     {"rgb", JpegForm{.stored = Stored::rgb}}})
        all.emplace_back(std::string(name) + ".jpg", jpeg_of(9, 9, rgb, form));
    all.emplace_back("grey.jpg", jpeg_of(9, 9, grey, {.stored = Stored::grey}));
    for (const bool marker : {false, true})
        all.emplace_back(marker ? "ycck.jpg" : "cmyk.jpg",
                         jpeg_of(9, 9, rgba, {.stored = marker ? Stored::ycck : Stored::cmyk, .adobe_marker = marker}));
    return all;
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: fuzz_seeds FOLDER\n", stderr);
        return 2;
    }
    const std::filesystem::path folder = arguments[1];
    for (const char* target : {"gltf", "pictures", "ies"})
        std::filesystem::create_directories(folder / target);
    const auto write = [&folder](const std::string& name, const Bytes& bytes) {
        std::ofstream(folder / name, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    };
    const Bytes pixels = solid(4, 4, {200, 100, 50, 128});
    write("gltf/triangle.glb", GltfBuilder::triangle().glb());
    write("gltf/triangle.gltf", GltfBuilder::triangle().gltf());
    write("gltf/png.glb", with_texture(png(4, 4, pixels)).glb());
    write("gltf/jpeg.glb", with_texture(jpeg(4, 4, pixels)).glb());
    write("gltf/webp-lossless.glb", with_texture(webp_lossless(4, 4, pixels)).glb());
    write("gltf/webp-lossy.glb", with_texture(webp_lossy(4, 4, pixels)).glb());
    write("gltf/sparse.glb", with_sparse().glb());
    write("gltf/nodes.glb", with_nodes().glb());
    write("gltf/draco-edgebreaker.glb", draco_grid(true).glb());
    write("gltf/draco-sequential.glb", draco_grid(false).glb());
    write("gltf/meshopt.glb", meshopt_grid().glb());
    write("gltf/animation.glb", with_animation().glb());
    write("gltf/draco-joints.glb", draco_grid(true, nullptr, true).glb());
    write("gltf/meshopt-joints.glb", meshopt_grid(true).glb());
    write("gltf/cookie.glb", with_cookie().glb());
    for (const auto& [name, bytes] : pictures())
        write("pictures/" + name, bytes);
    for (const auto& [name, text] :
         {std::pair("ies/quarter.ies",
                    "IESNA91\n[TEST] 1\nTILT=NONE\n1 -1 2 3 2 1 2 0 0 0\n1 1 9\n0 45 90\n0 90\n1 2 3\n4 5 6\n"),
          {"ies/tilt.ies", "TILT=INCLUDE\n1 2 0 90 1 .9\n1 1 1 2 1 1 1 0 0 0 1 1 0 0 180 0 7 8"}})
        write(name, Bytes(text, text + std::strlen(text)));
    return 0;
}
