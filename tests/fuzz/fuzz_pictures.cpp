#include <cstdint>
#include <cstring>
#include <scene/images/decode.hpp>
#include <span>

// Any bytes end in a picture of the size that its header says, or in one DecodeError of one line.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    using namespace prelight;
    const std::span<const uint8_t> bytes(data, size);
    try {
        const images::Cost cost = images::inspect(bytes);
        if (uint64_t(cost.width) * cost.height > 1 << 22) // allowed, but no food for a fuzzer
            return 0;
        for (const uint32_t halvings : {0u, 1u}) {
            const TextureImage image = images::decode(bytes, halvings, images::Texels::colour);
            if (image.width != images::halved(cost.width, halvings) ||
                image.height != images::halved(cost.height, halvings) ||
                image.rgba.size() != size_t(image.width) * image.height * 4)
                __builtin_trap();
        }
    } catch (const DecodeError& error) {
        if (std::strchr(error.what(), '\n'))
            __builtin_trap();
    }
    return 0;
}
