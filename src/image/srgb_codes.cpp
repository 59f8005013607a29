#include "srgb_codes.hpp"
#include <prelight/image.hpp>

namespace prelight {

const std::array<float, 256>& srgb_linear() {
    static const std::array<float, 256> linear = [] {
        std::array<float, 256> of;
        for (size_t code = 0; code < of.size(); ++code)
            of[code] = srgb_decode(static_cast<float>(code) / 255);
        return of;
    }();
    return linear;
}

} // namespace prelight
