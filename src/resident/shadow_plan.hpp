#pragma once
#include "frustum.hpp"
#include "light_reach.hpp"
#include "shadow_atlas.hpp"
#include "shadow_views.hpp"
#include <optional>
#include <prelight/renderer.hpp>
#include <shared/frame.h>
#include <shared/shadow.h>
#include <span>

namespace prelight::resident {

/// The setting `shadow-filter`, in the order of SHADOW_FILTER_….
enum class ShadowFilter { hard, pcf, contact };

/// The setting `transparent-shadows`: what blended surfaces cast.
enum class TransparentShadows {
    opaque,     ///< the shadows of opaque ones
    filtered,   ///< they leave 1 − alpha of the light, behind the nearest of them what all leave together
    stochastic, ///< they cast in as many texels as alpha says
    none
};

struct ShadowOptions {
    bool on = false;
    ShadowFilter filter = ShadowFilter::pcf;
    TransparentShadows blended = TransparentShadows::opaque;
    uint64_t budget = 1u << 24; ///< texels of the atlas
    double detail = 2;          ///< texels of a map that a pixel asks for
    bool reuse = false;         ///< each light has the whole atlas, one after the other
    bool cached = true;         ///< tiles whose light and casters did not move are not drawn again
    uint32_t updates = ~0u;     ///< that many tiles are drawn in a frame, beside cascades
};

/// All that a tile's map is drawn from: two that are equal hold the same texels. Who draws one is given nothing else,
/// so that what he needs besides must become a field here, and is compared.
struct ShadowMap {
    ShadowTilePlace place;
    glm::dvec3 centre{0};           ///< the world's, which all that is drawn stands relative to
    glm::mat4 clip_from_centre{1};  ///< world relative to it
    std::vector<uint32_t> casters;  ///< indices into the plan's draws, rising
    std::vector<uint32_t> versions; ///< Draw::version of each
    glm::dmat3 viewer{0};           ///< the camera's axes, where a caster faces it
    bool operator==(const ShadowMap&) const = default;
};

/// How a light looks through one of its tiles: all that decides what casts in it.
struct ShadowSight {
    LightVolume light;
    glm::mat4 clip_from_centre{1};
    bool operator==(const ShadowSight&) const = default;
};

/// One tile to be drawn, unless the atlas holds its map already.
struct ShadowTile {
    uint32_t light = 0, number = 0; ///< the light's first, second … tile
    bool cascade = false;
    ShadowSight sight;
    ShadowMap map;
};

/// A light with a shadow.
struct ShadowedLight {
    uint32_t light = 0;
    uint32_t first_tile = 0; ///< of its tiles, which follow one another
    uint32_t kind = 0;       ///< SHADOW_…
    /// As LightData::shadow has it.
    uint32_t number() const { return (first_tile + 1) * SHADOW_KINDS + kind; }
};

/// Which lights of a frame have shadows, in tiles of which size, with which casters, and what shaders know of them.
///
/// A light asks for as many texels as the picture has pixels where its light reaches, times
/// ShadowOptions::detail. Where all that is more than the budget, tiles become smaller by halves, those first
/// whose lights cover least of the screen; lights go without only when one texel a tile is too much.
class ShadowPlan {
public:
    /// `draws`: all that casts, alive as long as the plan, each with another version when it changes; `longest`: side
    /// of the largest image that the device makes.
    ShadowPlan(std::span<const Draw> draws, const ShadowOptions& options, uint32_t longest);

    /// For `visible` lights (indices into `lights`), in a picture of so many pixels. `aspect`: width ÷ height of what
    /// the camera sees.
    void update(std::span<const PlacedLight> lights, std::span<const uint32_t> visible, const PlacedCamera& camera,
                double aspect, uint32_t width, uint32_t height);

    const WorldBox& world() const { return world_; }
    glm::uvec2 atlas_size() const { return atlas_.size(); }
    const ShadowOptions& options() const { return options_; }
    const std::vector<ShadowTile>& tiles() const { return tiles_; }
    const std::vector<shared::ShadowData>& records() const { return records_; } ///< beside tiles()
    /// In the order of the lights.
    const std::vector<ShadowedLight>& lights() const { return lights_; }
    /// The first directional light of lights().
    std::optional<ShadowedLight> sun() const { return sun_; }
    /// Without what the pass knows: tiles drawn and reused, casters.
    const ShadowStats& stats() const { return stats_; }

private:
    struct Wish {
        uint32_t light = 0, tiles = 0, side = 0;
        double pixels = 0; ///< of the screen, across its sphere
        double across = 0; ///< of these, what a tile must show
    };
    uint32_t largest_alone(uint32_t tiles) const;
    void wish(std::span<const PlacedLight> lights, std::span<const uint32_t> visible, const PlacedCamera& camera,
              uint32_t width, uint32_t height);
    void fit_budget();
    /// Lights that do not fit even by themselves are left out.
    void fit_each();
    void place(std::vector<ShadowTilePlace>& places);
    shared::ShadowData record(const Light& light, const ShadowView& view, const ShadowTilePlace& place,
                              const PlacedCamera& camera) const;
    /// Tiles of one light. `viewer`: the camera's axes. `before`: where those of the frame before begin that may be its
    /// own; it moves on.
    void add_tiles(const Wish& wish, const PlacedLight& light, std::span<const ShadowView> views,
                   std::span<const ShadowTilePlace> places, const glm::dmat3& viewer,
                   std::vector<ShadowTile>::iterator& before);
    void find_moved();
    bool casts(const Frustum& sight, uint32_t draw) const;
    /// Of a tile that looks as in the frame before: its casters, but for those that moved.
    std::vector<uint32_t> casters_still(const ShadowSight& sight, std::vector<uint32_t> before) const;
    std::vector<uint32_t> casters_of(const ShadowSight& sight, std::span<const uint32_t> reached) const;

    std::span<const Draw> draws_;
    std::vector<uint32_t> versions_; ///< of the draws at the last update()
    std::vector<uint32_t> moved_;    ///< draws with another one, rising
    WorldBox world_;
    ShadowOptions options_;
    ShadowAtlas atlas_;
    std::vector<Wish> wishes_;
    std::vector<ShadowTile> tiles_, before_; ///< of this frame and of the one before
    std::vector<shared::ShadowData> records_;
    std::vector<ShadowedLight> lights_;
    std::optional<ShadowedLight> sun_;
    ShadowStats stats_;
};

} // namespace prelight::resident
