#pragma once
#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <prelight/scene.hpp>
#include <vector>

namespace prelight::reference {

/// A picture and its smaller forms: level k has max(1, size >> k) texels a side, each the mean of level 0 over what it
/// covers, in linear light.
class Pyramid {
public:
    /// The part of the picture from column `left` on that is `width` wide.
    Pyramid(const TextureImage& image, uint32_t left, uint32_t width);
    struct Level {
        int64_t width = 1, height = 1;
        std::vector<glm::dvec3> texels;
        glm::dvec3 at(int64_t x, int64_t y) const { return texels[static_cast<size_t>(y * width + x)]; }
    };
    std::vector<Level> levels;
};

/// What one light sends in which direction, as docs/cookies.md defines it.
class LightDistribution {
public:
    using Pictures = std::map<uint32_t, std::shared_ptr<const std::vector<Pyramid>>>;
    /// `pictures`: those of other lights of the world, so that each is prepared once.
    LightDistribution(const World& world, const PlacedLight& light, Pictures& pictures);
    /// Factor of the light's intensity, 0 … 1. `direction`: unit, from the light; `spread`: the angle that a pixel
    /// at the lit point covers, seen from the light, radians.
    glm::dvec3 factor(glm::dvec3 direction, double spread) const;

private:
    glm::dvec3 spot(glm::dvec3 d, double spread) const;
    glm::dvec3 sphere(glm::dvec3 d, double spread) const;
    glm::dvec3 cube(glm::dvec3 d, double spread) const;
    double profile(glm::dvec3 d) const;

    glm::dmat3 axes_{1};
    LightKind kind_;
    double tangent_ = 1;                                 ///< of a spot's outer cone
    std::shared_ptr<const std::vector<Pyramid>> cookie_; ///< one, or six faces; null: none
    std::shared_ptr<const LightProfile> profile_;
};

} // namespace prelight::reference
