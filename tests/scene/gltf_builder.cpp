#include "gltf_builder.hpp"
#include "pictures.hpp"
#include <fstream>
#include <image/png_writer.hpp>
#include <prelight/error.hpp>
#include <prelight/scene_io.hpp>
#include <random>
#include <scene/gltf/load.hpp>
#include <webp/encode.h>

namespace prelight::test {

GltfBuilder::GltfBuilder() { json = {{"asset", {{"version", "2.0"}}}}; }

GltfBuilder GltfBuilder::triangle() {
    GltfBuilder b;
    const size_t positions = b.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
    b.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", positions}}}}}}}};
    b.json["nodes"] = {{{"mesh", 0}}};
    b.json["scenes"] = {{{"nodes", {0}}}};
    b.json["scene"] = 0;
    return b;
}

GltfBuilder GltfBuilder::textured_triangle() {
    GltfBuilder b = triangle();
    b.attributes()["NORMAL"] = b.add_floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
    b.attributes()["TEXCOORD_0"] = b.add_floats({0, 0, 1, 0, 0, 1}, "VEC2");
    b.json["materials"] = Json::array({Json::object()});
    b.primitive()["material"] = 0;
    return b;
}

size_t GltfBuilder::add_view(const Bytes& bytes, size_t stride) {
    binary.resize((binary.size() + 3) & ~size_t(3));
    Json view = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}};
    if (stride != 0)
        view["byteStride"] = stride;
    json["bufferViews"].push_back(view);
    binary.insert(binary.end(), bytes.begin(), bytes.end());
    json["buffers"][0]["byteLength"] = binary.size();
    return json["bufferViews"].size() - 1;
}

size_t GltfBuilder::add_accessor(const Json& accessor) {
    json["accessors"].push_back(accessor);
    return json["accessors"].size() - 1;
}

size_t GltfBuilder::add_image(const Bytes& file) {
    json["images"].push_back({{"bufferView", add_view(file)}, {"mimeType", "image/png"}});
    return json["images"].size() - 1;
}

Bytes glb_of(const std::string& json, const Bytes& binary) {
    Bytes out;
    const auto word = [&out](size_t value) {
        for (int shift = 0; shift < 32; shift += 8)
            out.push_back(uint8_t(value >> shift));
    };
    const auto padded = [](size_t size) { return (size + 3) & ~size_t(3); };
    word(0x46546c67);
    word(2);
    word(20 + padded(json.size()) + (binary.empty() ? 0 : 8 + padded(binary.size())));
    word(padded(json.size()));
    word(0x4e4f534a);
    out.insert(out.end(), json.begin(), json.end());
    out.resize(20 + padded(json.size()), ' ');
    if (!binary.empty()) {
        word(padded(binary.size()));
        word(0x004e4942);
        out.insert(out.end(), binary.begin(), binary.end());
        out.resize((out.size() + 3) & ~size_t(3), 0);
    }
    return out;
}

Bytes GltfBuilder::glb() const { return glb_of(json.dump(), binary); }

Bytes GltfBuilder::gltf() const {
    Json copy = json;
    copy["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(binary);
    const std::string text = copy.dump();
    return {text.begin(), text.end()};
}

std::string base64(const Bytes& bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        const size_t left = std::min<size_t>(3, bytes.size() - i);
        uint32_t word = 0;
        for (size_t k = 0; k < 3; ++k)
            word = word << 8 | (k < left ? bytes[i + k] : 0u);
        for (size_t k = 0; k < 4; ++k)
            out += k <= left ? digits[word >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

Scene load_bytes(const Bytes& bytes) { return gltf::load(bytes, "test.glb", std::filesystem::temp_directory_path()); }
Scene load_text(const std::string& json) { return load_bytes({json.begin(), json.end()}); }
Scene GltfBuilder::load() const { return load_bytes(glb()); }

namespace {
Bytes take(uint8_t* data, size_t size) {
    Bytes out(data, data + size);
    WebPFree(data);
    return out;
}
} // namespace

Bytes png(uint32_t width, uint32_t height, const Bytes& rgba) {
    const auto file = encode_png(width, height, 4, rgba);
    const auto* begin = reinterpret_cast<const uint8_t*>(file.data());
    return {begin, begin + file.size()};
}

Bytes jpeg(uint32_t width, uint32_t height, const Bytes& rgba) {
    Bytes rgb;
    for (size_t i = 0; i < rgba.size(); i += 4)
        rgb.insert(rgb.end(), {rgba[i], rgba[i + 1], rgba[i + 2]});
    return jpeg_of(width, height, rgb, {.quality = 95});
}

Bytes webp_lossless(uint32_t width, uint32_t height, const Bytes& rgba) {
    uint8_t* out = nullptr;
    const size_t size = WebPEncodeLosslessRGBA(rgba.data(), int(width), int(height), int(width) * 4, &out);
    return take(out, size);
}

Bytes webp_lossy(uint32_t width, uint32_t height, const Bytes& rgba) {
    uint8_t* out = nullptr;
    const size_t size = WebPEncodeRGBA(rgba.data(), int(width), int(height), int(width) * 4, 95, &out);
    return take(out, size);
}

Bytes solid(uint32_t width, uint32_t height, std::vector<uint8_t> colour) {
    Bytes out;
    for (size_t i = 0; i < size_t(width) * height; ++i)
        out.insert(out.end(), colour.begin(), colour.end());
    return out;
}

namespace {
std::string error_of(const Bytes& bytes, const LoadOptions& options) {
    try {
        const Scene scene = gltf::load(bytes, "test.glb", std::filesystem::temp_directory_path(), options);
        resolve(scene);
        resolve(scene, {}, Moment{0.5});
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}
} // namespace

std::string error_of(const Bytes& bytes) { return error_of(bytes, {}); }
std::string strict_error_of(const GltfBuilder& builder) { return error_of(builder.glb(), {.strict = true}); }

std::string error_of(const GltfBuilder& builder) { return error_of(builder.glb()); }
std::string error_of_text(const std::string& json) { return error_of(Bytes(json.begin(), json.end())); }

size_t peak_memory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind("VmHWM:", 0) == 0)
            return std::stoull(line.substr(6)) * 1024;
    return 0;
}

void reset_peak_memory() { std::ofstream("/proc/self/clear_refs") << 5; }

TemporaryFolder::TemporaryFolder() {
    std::random_device random;
    path = std::filesystem::temp_directory_path() /
           ("prelight-test-" + std::to_string(random()) + std::to_string(random()));
    std::filesystem::create_directories(path);
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

std::filesystem::path TemporaryFolder::write(const std::string& name, const Bytes& bytes) const {
    const std::filesystem::path file = path / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    return file;
}

} // namespace prelight::test
