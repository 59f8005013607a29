#pragma once
#include "shadow_maps.hpp"
#include <map>

namespace prelight::passes {

/// The maps that an atlas holds, by corner, and the images beside it. Those of one graph: its images are new with it.
struct HeldMaps {
    std::map<std::pair<uint32_t, uint32_t>, resident::ShadowMap> maps;
    std::vector<resident::ShadowMap>
        drawn; ///< into the atlas by the last ShadowDraws::record(): they are new in all of them
};

/// Which image of the two that Shadows has.
enum class ShadowTarget { depth, transmittance };

/// Draws the maps that resident::ShadowPlan lists, and knows which ones the image holds already. Records into a pass
/// that writes the image, or between the draws of one.
class ShadowDraws {
public:
    /// `inputs`: the pass's, of which nothing is read.
    ShadowDraws(const resident::View& view, VkDescriptorSetLayout inputs, const Shadows& shadows,
                ShadowTarget target = ShadowTarget::depth);
    ~ShadowDraws();
    /// All tiles of the frame; with ShadowTarget::transmittance those that the pass of depth has just drawn.
    void record(const graph::PassContext& pass);
    /// Light by light: once before the first, then each before it is drawn.
    void begin(const graph::PassContext& pass);
    void record_light(const graph::PassContext& pass, uint32_t light);

private:
    class Casters;
    /// Unless the atlas holds it; whether it was drawn.
    bool draw_anew(const graph::PassContext& pass, const resident::ShadowMap& map);
    bool held(const resident::ShadowMap& map) const;
    void draw(const graph::PassContext& pass, const resident::ShadowMap& map);

    const resident::View& view_;
    ShadowCounts& counts_;
    std::shared_ptr<HeldMaps> held_;
    ShadowTarget target_;
    std::unique_ptr<Casters> casters_;
};

} // namespace prelight::passes
