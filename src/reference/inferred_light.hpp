#pragma once
#include <map>
#include <reference/seen_world.hpp>

namespace prelight::reference {

/// Light of a lower resolution and how pixels find theirs in it (docs/inferred.md), written from the same description
/// as the renderer `inferred` and from none of its code.
class InferredLight {
public:
    /// `width` and `height`: of the picture. `factor`: exposure. `form` has an inferred_scale, and stays.
    InferredLight(const World& world, const PlacedCamera& camera, uint32_t width, uint32_t height,
                  const ReferenceForm& form, double factor);

    uint32_t rows() const { return height_; }
    /// Casts the rays of one row of texels and lights what they meet. Rows may be done at once.
    void light_row(uint32_t y);
    /// Once all rows are there: which texels the rasteriser, or a shadow map, may see otherwise.
    void find_doubts();

    /// What a pixel's surface gets.
    struct Found {
        LightSums sums;
        double visibility = 1;  ///< of ambient light
        bool unmatched = false; ///< none of the four texels around it shows its surface
        bool doubtful = false;  ///< a texel that counts is, or whether one counts is too close
    };
    /// For a surface that the ray through the middle of a pixel meets; `layer`: a blended one.
    Found at(uint32_t x, uint32_t y, const Hit& hit, bool layer) const;

private:
    /// What one texel holds. `draw` is counted from 1, 0 being nothing; `closeness` is linear over the screen on a
    /// plane: 1 / depth, or −depth where the camera is orthographic.
    struct Texel {
        uint32_t draw = 0, group = 0;
        double closeness = 0;
        LightSums sums;
        double visibility = 1;
        uint64_t shadow_mask = 0;
        bool doubtful = false;
    };
    struct Seen {
        Hit hit, opaque;
        bool found = false, layer = false;
    };
    struct Tap {
        glm::ivec2 at{0};
        double share;
    };
    Seen look(uint32_t x, uint32_t y, glm::dvec2 place) const;
    uint32_t group_of(const Hit& hit) const;
    double closeness(double depth) const;
    /// Of the hit's plane under a place of the texels.
    double plane_at(const Hit& hit, glm::dvec2 place) const;
    const Texel& texel(glm::ivec2 at) const { return texels_[size_t(at.y) * width_ + at.x]; }
    bool find_nearest(glm::dvec2 place, const Hit& hit, double width, glm::ivec2& nearest, bool& doubtful) const;
    void number_groups();
    void choose_slots(const World& world);

    uint32_t frame_width_, frame_height_, width_, height_;
    const ReferenceForm& form_;
    double factor_;
    SeenWorld world_;
    std::vector<Texel> texels_;
    std::map<const Primitive*, std::vector<uint32_t>> groups_; ///< of each vertex
    std::vector<uint32_t> slots_;                              ///< by draw; 0: it is no layer
};

} // namespace prelight::reference
