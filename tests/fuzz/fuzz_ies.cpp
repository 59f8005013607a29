#include <cstdint>
#include <cstring>
#include <prelight/error.hpp>
#include <prelight/light_distribution.hpp>
#include <string_view>

// Any bytes end in a profile that holds together or in one Error of one line.
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    try {
        const prelight::LightProfile profile =
            prelight::parse_profile({reinterpret_cast<const char*>(data), size}, "fuzz");
        if (profile.candela.size() != profile.vertical.size() * profile.horizontal.size() || !(profile.largest > 0))
            __builtin_trap();
        for (const double candela : profile.candela)
            if (!(candela >= 0 && candela <= profile.largest))
                __builtin_trap();
    } catch (const prelight::Error& error) {
        if (std::strchr(error.what(), '\n'))
            __builtin_trap();
    }
    return 0;
}
