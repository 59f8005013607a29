#pragma once
#include "shadow_maps.hpp"
#include <map>
#include <resident/trim_casters.hpp>

namespace prelight::passes {

/// The maps that an atlas holds, by their first texels along its curve, and the images beside it. Those of one graph:
/// its images are new with it.
struct HeldMaps {
    struct Map {
        resident::ShadowMap map;
        uint32_t light = 0, number = 0; ///< of its tile
        uint64_t frame = 0;             ///< that drew it; 0: it waits for its turn, without casters
    };
    std::map<uint64_t, Map> maps;
    uint64_t frame = 0; ///< how many were recorded
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
    /// Whether the atlas holds the tile's map, which is counted.
    bool reuses(const resident::ShadowTile& tile);
    /// What stands in the tile's place: an earlier map of the same tile. Null: nothing that is its own.
    const HeldMaps::Map* earlier(const resident::ShadowTile& tile) const;
    /// The atlas holds the map from now on, and none that it overlaps.
    void hold(const resident::ShadowTile& tile, const resident::ShadowMap& map, uint64_t frame);
    /// Of the tiles that have to be drawn those whose turn it is, moved to the front; how many. What never had a map
    /// comes first, then what has the oldest.
    size_t choose(std::vector<const resident::ShadowTile*>& due) const;
    /// `trimmed`: of its casters; empty: they are drawn whole.
    void draw(const graph::PassContext& pass, const resident::ShadowMap& map,
              std::span<const resident::VisibleDraw> trimmed = {});
    void count(const resident::ShadowMap& map);
    void draw_trimmed(const graph::PassContext& pass, std::span<const resident::ShadowMap> maps);

    const resident::View& view_;
    ShadowCounts& counts_;
    std::shared_ptr<HeldMaps> held_;
    ShadowTarget target_;
    std::unique_ptr<Casters> casters_;
};

} // namespace prelight::passes
