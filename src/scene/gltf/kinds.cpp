#include <fmt/format.h>
#include <scene/gltf/kinds.hpp>

namespace prelight::gltf {
namespace {

/// What 1 is stored as.
float whole(Component component) {
    switch (component) {
    case Component::i8: return 127;
    case Component::u8: return 255;
    case Component::i16: return 32767;
    case Component::u16: return 65535;
    default: return 1;
    }
}

bool is_unsigned(Component component) { return component == Component::u8 || component == Component::u16; }

std::string kind_of(const Elements& e) {
    const char* component = e.component == Component::i8    ? "bytes"
                            : e.component == Component::u8  ? "unsigned bytes"
                            : e.component == Component::i16 ? "shorts"
                            : e.component == Component::u16 ? "unsigned shorts"
                            : e.component == Component::u32 ? "unsigned ints"
                                                            : "floats";
    const std::string type = e.columns > 1  ? fmt::format("MAT{}", e.columns)
                             : e.width == 1 ? "SCALAR"
                                            : fmt::format("VEC{}", e.width);
    return fmt::format("{} of {}{}", type, e.normalized ? "normalized " : "", component);
}

/// What glTF allows for a use.
struct Wanted {
    uint32_t width;
    const char* components; ///< for messages
    bool normalized;        ///< integers are
};

Wanted wanted_of(Semantic semantic) {
    switch (semantic) {
    case Semantic::position:
    case Semantic::normal:
    case Semantic::position_delta:
    case Semantic::normal_delta:
    case Semantic::tangent_delta: return {3, "floats", false};
    case Semantic::tangent: return {4, "floats", false};
    case Semantic::texcoord: return {2, "floats or normalized unsigned bytes or shorts", true};
    case Semantic::colour: return {3, "floats or normalized unsigned bytes or shorts", true};
    case Semantic::joints: return {4, "unsigned bytes or shorts", false};
    case Semantic::weights: return {4, "floats or normalized unsigned bytes or shorts", true};
    }
    return {};
}

bool is_direction(Semantic semantic) { return semantic == Semantic::normal || semantic == Semantic::tangent; }

/// A kind that glTF, or the extension where the file uses it, knows for the use.
bool is_allowed(const Elements& e, Semantic semantic, bool quantized) {
    if (semantic == Semantic::joints)
        return is_unsigned(e.component) && !e.normalized;
    if (e.component == Component::f32)
        return !e.normalized;
    if (wanted_of(semantic).normalized && is_unsigned(e.component) && e.normalized)
        return true;
    if (!quantized || semantic == Semantic::colour || semantic == Semantic::weights)
        return false;
    return is_direction(semantic) ? !is_unsigned(e.component) && e.normalized : true;
}

} // namespace

std::string kind_mismatch(const Elements& found, std::string_view wanted) {
    return fmt::format("{} holds {}, not {}", found.label, kind_of(found), wanted);
}

Fit fit_attribute(const Elements& e, Semantic semantic, bool quantized) {
    const Wanted wanted = wanted_of(semantic);
    const std::string mismatch = kind_mismatch(e, fmt::format("VEC{} of {}", wanted.width, wanted.components));
    const bool integers = e.component != Component::f32;
    // Four colours are as good as three. Of a vector that is too long the rest means nothing.
    const bool exact = e.width == wanted.width || (semantic == Semantic::colour && e.width == 4);
    if (e.width < wanted.width || (semantic != Semantic::joints && e.component == Component::u32))
        return {.usable = false, .warning = mismatch};
    if (exact && is_allowed(e, semantic, quantized))
        return {};
    if (semantic == Semantic::joints)
        return {.divisor = integers && e.normalized ? 1 / whole(e.component) : 1,
                .warning = mismatch + "; they are read as whole numbers"};
    if (is_direction(semantic) && is_unsigned(e.component))
        return {.usable = false, .warning = mismatch}; // half of all directions cannot be said
    if (!exact && is_allowed(e, semantic, quantized))
        return {.warning = fmt::format("{}; of each the first {} count", mismatch, wanted.width)};
    if (!integers)
        return {.warning = mismatch + "; what is normalized are integers"};
    if (wanted.normalized && !e.normalized)
        return {.divisor = whole(e.component), .warning = mismatch + "; they are read as normalized"};
    return {.warning = mismatch + (is_direction(semantic) ? "; their directions count" : "; their values count")};
}

Fit fit_animation(const Elements& e, AnimationPath path) {
    const bool rotation = path == AnimationPath::rotation, weights = path == AnimationPath::weights;
    const uint32_t width = rotation ? 4 : weights ? 1 : 3;
    const std::string type = width == 1 ? "SCALAR" : fmt::format("VEC{}", width);
    const std::string mismatch = kind_mismatch(
        e, fmt::format("{} of floats{}", type, rotation || weights ? " or normalized bytes or shorts" : ""));
    const bool floats = e.component == Component::f32;
    if (e.width != width || e.component == Component::u32 || (!floats && !e.normalized && !rotation && !weights))
        return {.usable = false, .warning = mismatch};
    if (!floats && !e.normalized)
        return {.divisor = whole(e.component), .warning = mismatch + "; they are read as normalized"};
    if (floats ? e.normalized : !rotation && !weights)
        return {.warning = mismatch + "; their values count"};
    return {};
}

} // namespace prelight::gltf
