#pragma once
#include <reference/surface.hpp>

namespace prelight::reference {

/// How far two samples of a pixel may differ and yet share a surface (ReferenceSamples).
struct Likeness {
    double cosine;    ///< at least, between their normals
    double roughness; ///< at most, relative to the first one's
    double colour;    ///< what else a G-buffer stores: at most, relative to the first one's, or to 0.02; infinity: does
                      ///< not count
};

/// An answer, and whether what is stored of surfaces could change it.
struct Shared {
    bool yes = false, clear = true;
};

/// Whether several answers are all yes. A clear no makes the others not matter.
class AllShared {
public:
    void add(const Shared& one) {
        if (!one.yes && one.clear)
            sum_ = one;
        else if (sum_.yes || !sum_.clear)
            sum_ = {sum_.yes && one.yes, sum_.clear && one.clear};
    }
    const Shared& sum() const { return sum_; }

private:
    Shared sum_{true, true};
};

/// What is compared of a sample.
struct Looks {
    const Surface& surface;
    double depth;        ///< view depth
    glm::dvec3 light{0}; ///< exposed, that a G-buffer holds: all but what lights add
};

/// `pixel`: metres that a pixel covers across the view at the first one's depth.
Shared share_surface(const Looks& first, const Looks& other, double pixel, const Likeness& likeness);

} // namespace prelight::reference
