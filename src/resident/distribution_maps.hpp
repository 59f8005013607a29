#pragma once
#include <map>
#include <prelight/light_distribution.hpp>
#include <shared/frame.h>
#include <span>
#include <vector>

namespace prelight::resident {

/// Cookies and profiles of lights, level by level side by side in one picture; each image and profile once.
class DistributionMaps {
public:
    /// Of these lights; others among them do no harm. `longest`: the most texels that the picture may have a side.
    /// Throws Error "SCENE: …" when they need more.
    DistributionMaps(const Scene& scene, std::span<const PlacedLight> lights, uint32_t longest);

    bool empty() const { return levels_.empty(); }
    /// Whether the light's are there.
    bool hold(const Light& light) const;
    /// A light of those that the maps hold.
    shared::DistributionData record(const PlacedLight& light) const;
    std::span<const shared::DistributionLevel> levels() const { return levels_; }
    const Image& picture() const { return picture_; }

private:
    /// An image as a point light throws it need not be as a spot throws it.
    using CookieKey = std::pair<uint32_t, CookieKind>;
    struct Cookie {
        uint32_t first = 0, last = 0; ///< DistributionLevel; number of the last level of each face
        double texels = 0;            ///< a radian on the axis, but for a spot's tangent
    };
    struct Profile {
        std::shared_ptr<const LightProfile> kept; ///< so that its address stays its own
        uint32_t level = 0, columns = 1, rows = 2;
    };
    const Scene* scene_;
    std::map<CookieKey, Cookie> cookies_;
    std::map<const LightProfile*, Profile> profiles_;
    std::vector<shared::DistributionLevel> levels_;
    glm::dvec2 texel_{1}; ///< 1 / size of the picture
    Image picture_;
};

} // namespace prelight::resident
