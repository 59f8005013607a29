#pragma once
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <prelight/scene.hpp>
#include <string>
#include <vector>

namespace prelight::test {

using Bytes = std::vector<uint8_t>;
using Json = nlohmann::json;

/// The bytes of values as they lie in memory.
template <class T>
Bytes bytes_of(const std::vector<T>& values) {
    Bytes out(values.size() * sizeof(T));
    std::memcpy(out.data(), values.data(), out.size());
    return out;
}

/// Makes small glTF files. `json` is free to be changed, also to something wrong.
class GltfBuilder {
public:
    /// One white triangle (0,0,0), (1,0,0), (0,1,0) without normals: mesh 0 of node 0 of scene 0.
    static GltfBuilder triangle();
    /// The same with normals and texture coordinates, and material 0.
    static GltfBuilder textured_triangle();
    GltfBuilder();

    size_t add_view(const Bytes& bytes, size_t stride = 0);
    size_t add_accessor(const Json& accessor);
    /// View and accessor of packed values. `type`: "VEC3" …; `component`: 5126 …
    template <class T>
    size_t add_values(const std::vector<T>& values, int component, const std::string& type) {
        const size_t side = type == "SCALAR" ? 1 : size_t(type.back() - '0');
        const size_t width = type[0] == 'M' ? side * side : side; // packed: not for MAT2, MAT3 of bytes
        return add_accessor({{"bufferView", add_view(bytes_of(values))},
                             {"componentType", component},
                             {"type", type},
                             {"count", values.size() / width}});
    }
    size_t add_floats(const std::vector<float>& values, const std::string& type) {
        return add_values(values, 5126, type);
    }
    size_t add_image(const Bytes& file); ///< image in a view; returns its index
    Json& primitive() { return json["meshes"][0]["primitives"][0]; }
    Json& attributes() { return primitive()["attributes"]; }

    Bytes glb() const;
    /// The JSON as .gltf with the binary data as base64.
    Bytes gltf() const;
    /// Loads `glb()` as "test.glb" from memory.
    Scene load() const;

    Json json;
    Bytes binary;
};

Bytes glb_of(const std::string& json, const Bytes& binary);
std::string base64(const Bytes& bytes);
Scene load_bytes(const Bytes& bytes);
Scene load_text(const std::string& json);

/// Encoded pictures of one colour, or of given RGBA bytes.
Bytes png(uint32_t width, uint32_t height, const Bytes& rgba);
Bytes jpeg(uint32_t width, uint32_t height, const Bytes& rgba);
Bytes webp_lossless(uint32_t width, uint32_t height, const Bytes& rgba);
Bytes webp_lossy(uint32_t width, uint32_t height, const Bytes& rgba);
Bytes solid(uint32_t width, uint32_t height, std::vector<uint8_t> colour);

/// The builder's file with its triangle in Draco (edgebreaker or sequential) or meshopt form.
/// `joints`: vertices follow joint 1 by x / 4 and joint 0 by the rest; nodes and a skin come with it,
/// joint 1 lies 8 m up in z.
GltfBuilder draco_grid(bool edgebreaker, Bytes* draco = nullptr, bool joints = false);
GltfBuilder meshopt_grid(bool joints = false);

/// The one line of the Error that loading and resolving (at rest and at 0.5 s) gives; empty when there is none.
std::string error_of(const Bytes& bytes);
std::string error_of(const GltfBuilder& builder);
std::string error_of_text(const std::string& json);
/// The same where every warning is an error.
std::string strict_error_of(const GltfBuilder& builder);
/// Expects that the file is repaired: it loads with this warning (its start, after "test.glb: "), and read
/// strictly ends in it.
Scene expect_repaired(const GltfBuilder& builder, const std::string& warning);

/// One change of a good file and the start of the line that it must give.
struct Damage {
    const char* name;
    std::function<void(GltfBuilder&)> change;
    std::string line;
    bool repaired = false; ///< by default; the line is a warning's then
};
/// Expects that the file is good, and after the change refused in that one line or repaired with that warning.
void expect_told(GltfBuilder good, const Damage& damage);

inline constexpr float no_number = std::numeric_limits<float>::quiet_NaN();

/// A folder of its own for one test, removed with everything in it.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::filesystem::path write(const std::string& name, const Bytes& bytes) const;
    std::filesystem::path path;
};

/// Most memory that the process has had so far, in bytes (VmHWM), and the call that starts it anew.
size_t peak_memory();
void reset_peak_memory();

/// Bytes that `work` takes at most beyond what is there before it.
template <class Work>
size_t memory_growth(Work work) {
    reset_peak_memory();
    const size_t before = peak_memory();
    work();
    const size_t after =
        peak_memory(); // the kernel counts in batches: a little less than before, where nothing was taken
    return after > before ? after - before : 0;
}

/// The address sanitizer's own memory makes such figures useless.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

} // namespace prelight::test
