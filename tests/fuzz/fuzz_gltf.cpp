#include <cstdint>
#include <cstring>
#include <filesystem>
#include <prelight/error.hpp>
#include <prelight/scene.hpp>
#include <scene/gltf/load.hpp>
#include <span>
#include <vector>

// Any bytes end in a scene that resolves or in one Error of one line. URIs lead to a folder that does
// not exist, so that nothing is read from the machine.

namespace {

void load(std::span<const uint8_t> bytes) {
    try {
        // Memory that does not depend on the machine: the same bytes give the same path.
        const prelight::LoadOptions options{.memory_limit = uint64_t(512) << 20};
        const prelight::Scene scene = prelight::gltf::load(bytes, "fuzz", "/nonexistent", options);
        for (uint32_t i = 0; i < scene.scenes.size() && i < 4; ++i)
            for (const auto& moment : {std::optional<prelight::Moment>(), {prelight::Moment{0.5}}})
                prelight::resolve(scene, i, moment);
    } catch (const prelight::Error& error) {
        if (std::strchr(error.what(), '\n'))
            __builtin_trap();
    }
}

void put(std::vector<uint8_t>& bytes, size_t at, size_t value) {
    for (size_t i = 0; i < 4; ++i)
        bytes[at + i] = uint8_t(value >> (8 * i));
}

/// Makes the lengths of a .glb right again: a mutation that inserts a byte would else end there.
std::vector<uint8_t> mended(std::span<const uint8_t> bytes) {
    std::vector<uint8_t> out(bytes.begin(), bytes.end());
    put(out, 8, out.size());
    uint32_t json = 0;
    std::memcpy(&json, out.data() + 12, 4);
    // The BIN chunk's type is looked for, since what lies before it may have grown or shrunk.
    for (size_t at = 20; at + 8 <= out.size(); ++at)
        if (std::memcmp(out.data() + at + 4, "BIN\0", 4) == 0) {
            while ((at - 20) % 4 != 0)
                out.insert(out.begin() + std::ptrdiff_t(at++), ' ');
            put(out, 8, out.size());
            put(out, 12, at - 20);
            put(out, at, out.size() - at - 8);
            return out;
        }
    put(out, 12, out.size() - 20);
    return out;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const std::span<const uint8_t> bytes(data, size);
    load(bytes);
    if (size >= 28 && std::memcmp(data, "glTF", 4) == 0)
        load(mended(bytes));
    return 0;
}
