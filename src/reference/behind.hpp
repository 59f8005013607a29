#pragma once
#include <glm/vec2.hpp>
#include <prelight/image.hpp>
#include <vector>

namespace prelight::reference {

/// A picture, sharp and ever more blurred, for what transmissive surfaces show of it (docs/transmission.md). Level 0 is
/// the picture; a texel of the next level is the mean of four by four of this one's, with weights 1 3 3 1 along either
/// axis, around the two by two that it takes the place of. Past its edges a level goes on as it ends.
class Behind {
public:
    explicit Behind(const Image& picture);
    /// At a place, pixels from the picture's top left; between the texels of a level and between levels linearly.
    glm::dvec3 at(glm::dvec2 place, double level) const;

private:
    struct Level {
        int width = 0, height = 0;
        std::vector<glm::dvec3> texels;
        glm::dvec3 texel(int x, int y) const;
        Level halved() const;
        /// `x`, `y`: texels from its top left.
        glm::dvec3 at(double x, double y) const;
    };
    std::vector<Level> levels_;
};

} // namespace prelight::reference
