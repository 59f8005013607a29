// CPU and GLSL compile shaders/shared/normal_encoding.h from the same text; here a device encodes into
// the real formats and decodes, and the CPU does the same.
#include "devices.hpp"
#include "directions.hpp"
#include <bench/through_target.hpp>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <shared/normal_encoding.h>

namespace prelight {
namespace {

using passes::NormalEncoding;

/// Bits of each channel in the order in which they lie in memory.
std::vector<int> channels(VkFormat format) {
    switch (format) {
    case VK_FORMAT_R8G8B8A8_UNORM: return {8, 8, 8, 8};
    case VK_FORMAT_R8G8_UNORM: return {8, 8};
    case VK_FORMAT_R16G16_UNORM:
    case VK_FORMAT_R16G16_SFLOAT: return {16, 16};
    case VK_FORMAT_A2B10G10R10_UNORM_PACK32: return {10, 10, 10, 2};
    default: ADD_FAILURE() << "format " << format; return {};
    }
}

/// A channel's code, as the format should round it.
uint32_t code(VkFormat format, float value, int bits) {
    if (format == VK_FORMAT_R16G16_SFLOAT)
        return glm::packHalf1x16(value);
    const float steps = static_cast<float>((1u << bits) - 1);
    return static_cast<uint32_t>(std::floor(value * steps + 0.5f));
}

float value(VkFormat format, uint32_t code, int bits) {
    if (format == VK_FORMAT_R16G16_SFLOAT)
        return glm::unpackHalf1x16(static_cast<uint16_t>(code));
    return static_cast<float>(code) / static_cast<float>((1u << bits) - 1);
}

/// The whole numbers that an encoding rounds to: channels, or the two that 12 + 12 bits hold.
glm::ivec4 numbers(NormalEncoding encoding, glm::ivec4 codes) {
    if (encoding != NormalEncoding::oct24 && encoding != NormalEncoding::spherical)
        return codes;
    const glm::vec2 two = shared::unpack_12_12(glm::vec3(codes) / 255.0f);
    return {two.x, two.y, codes.w, 0};
}

struct Expected {
    NormalEncoding encoding;
    double mean, max;    ///< degrees, measured by NormalEncoding.*AngularError
    double may_differ;   ///< share of codes that may be one step away
    double apart = 3e-5; ///< degrees between the two decoders: some units in the last place of a float
};
// The octahedral encodings round to whole steps themselves, xy16f to whole halves; the XYZ encodings
// leave it to the target, and lavapipe stores floor(1024 u) for ten bits instead of round(1023 u). That
// makes the stored normal longer by 1/1023, which the decoder's normalize() takes out again: the
// angles are held to the same bounds. Arc tangents of spherical and squares of xy16f may differ in the
// last place, and with them what lies between two codes. Vulkan lets sines be off by 2⁻¹¹, 0.028°;
// SwiftShader's are by 0.0056°.
constexpr Expected expected_errors[] = {{NormalEncoding::oct24, 0.0209, 0.0592, 0.0001},
                                        {NormalEncoding::oct32, 0.0013, 0.0037, 0.0001},
                                        {NormalEncoding::rgb10a2, 0.0422, 0.0960, 0.65},
                                        {NormalEncoding::rgb8, 0.1697, 0.3843, 0.0001},
                                        {NormalEncoding::spherical, 0.0221, 0.0492, 0.003, 0.0057},
                                        {NormalEncoding::oct16, 0.3368, 0.9510, 0.0001},
                                        {NormalEncoding::xy16f, 0.0271, 0.8930, 0.003}};

class NormalEncodingOnDevice : public OnEachDevice {};

TEST_P(NormalEncodingOnDevice, AgreesWithTheCpu) {
    const std::vector<glm::vec4> directions = bench::directions(512 * BENCH_WIDTH);
    ASSERT_EQ(std::size(expected_errors), passes::normal_encodings().size());
    for (const Expected& e : expected_errors) {
        const auto& info = passes::normal_encodings()[static_cast<size_t>(e.encoding)];
        ASSERT_EQ(info.encoding, e.encoding);
        SCOPED_TRACE(info.name);
        const bench::Stored through = bench::through_normal_target(context(), info, directions);
        ASSERT_EQ(through.format, info.formats[0]) << "SwiftShader and lavapipe have them all";
        const std::vector<int> bits = channels(through.format);
        const size_t bytes = graph::texel_bytes(through.format);
        const bool has_roughness = shared::normal_holds_roughness(static_cast<int>(e.encoding));
        int largest_step = 0;
        uint32_t differing = 0;
        double roughness = 0;
        Angles decoders, whole;
        for (size_t i = 0; i < directions.size(); ++i) {
            const glm::vec4 d = directions[i], back = through.decoded[i];
            const glm::vec4 encoded = shared::normal_encode(static_cast<int>(e.encoding), glm::vec3(d), d.w);
            uint32_t texel = 0;
            std::memcpy(&texel, &through.texels[i * bytes], bytes);
            glm::ivec4 device(0), host(0);
            glm::vec4 stored(0);
            for (int c = 0, shift = 0; c < static_cast<int>(bits.size()); shift += bits[c++]) {
                device[c] = static_cast<int>(texel >> shift & ((1u << bits[c]) - 1));
                host[c] = static_cast<int>(code(through.format, encoded[c], bits[c]));
                stored[c] = value(through.format, static_cast<uint32_t>(device[c]), bits[c]);
            }
            const glm::ivec4 step = glm::abs(numbers(e.encoding, device) - numbers(e.encoding, host));
            largest_step = std::max({largest_step, step.x, step.y, step.z});
            differing += step.x || step.y || step.z;
            decoders.add(angle(glm::vec3(back), shared::normal_decode(static_cast<int>(e.encoding), stored)));
            whole.add(angle(glm::vec3(d), glm::vec3(back)));
            if (has_roughness)
                roughness = std::max(roughness, std::abs(back.w / double(shared::roughness_decode(stored.w)) - 1));
        }
        std::printf("    %s: %u codes differ, by %d step at most; decoders apart by %.7f° at most\n", info.name,
                    differing, largest_step, decoders.max);
        EXPECT_LE(largest_step, 1);
        EXPECT_LE(differing, static_cast<double>(directions.size()) * e.may_differ);
        EXPECT_LE(decoders.max, e.apart);
        EXPECT_NEAR(whole.mean(), e.mean, e.mean * 0.01);
        EXPECT_LE(whole.max, e.max * 1.01 + e.apart);
        EXPECT_LE(roughness, 1e-5);
    }
}
INSTANTIATE_TEST_SUITE_P(Drivers, NormalEncodingOnDevice, testing::Values(Driver::lavapipe, Driver::swiftshader),
                         driver_name);

} // namespace
} // namespace prelight
