#pragma once
#include "shadow_maps.hpp"
#include <map>

namespace prelight::passes {

/// Draws tiles of shadow maps, each with the casters that its light reaches and the tile may show, and knows
/// which ones the image holds already. Records into a pass that writes the image, or between the draws of one.
class ShadowDraws {
public:
    /// `inputs`: the pass's, of which nothing is read.
    ShadowDraws(const resident::Frame& frame, VkDescriptorSetLayout inputs, ShadowCounts& counts);
    ~ShadowDraws();
    /// All tiles of the frame.
    void record(const graph::PassContext& pass);
    /// Light by light: once before the first, then each before it is drawn.
    void begin(const graph::PassContext& pass);
    void record_light(const graph::PassContext& pass, uint32_t light);

private:
    class Casters;
    void draw_anew(const graph::PassContext& pass, const resident::ShadowTile& tile);
    bool held(const resident::ShadowTile& tile) const;
    void draw(const graph::PassContext& pass, const resident::ShadowTile& tile);
    /// Those that the light reaches, once for all of its tiles; of them those that the tile may show.
    void find_casters(const resident::ShadowTile& tile);

    const resident::Frame& frame_;
    ShadowCounts& counts_;
    std::unique_ptr<Casters> casters_;
    std::map<std::pair<uint32_t, uint32_t>, resident::ShadowTile> held_; ///< by corner
    std::vector<uint32_t> reached_, seen_;
    uint32_t reached_of_ = no_image;
    glm::dvec3 reached_position_{0};
};

} // namespace prelight::passes
