#pragma once
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

namespace prelight {

/// SplitMix64 (Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014).
/// The standard's engines would do, but its distributions differ between libraries; here each
/// number is one integer step and one correctly rounded operation, so that a seed gives the same
/// bytes on every machine.
class Random {
public:
    explicit Random(uint64_t seed) : state(seed) {}

    /// All 64 bits random.
    uint64_t bits() {
        uint64_t z = (state += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    /// Uniform in 0 ≤ x < 1, a multiple of 2⁻⁵³.
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    /// Uniform in lo … hi. The explicit fma rounds once, whether or not a compiler contracts.
    double uniform(double lo, double hi) { return std::fma(unit(), hi - lo, lo); }
    /// Uniform in 0 ≤ i < count; count ≥ 1. The bias is below count · 2⁻³².
    uint32_t below(uint32_t count) { return static_cast<uint32_t>(((bits() >> 32) * count) >> 32); }

private:
    uint64_t state;
};

/// Linear RGB of a hue (turns, 0 ≤ hue ≤ 1) at full value; `saturation` 0 … 1.
glm::vec3 hue_colour(double hue, double saturation);

} // namespace prelight
