#pragma once
#include <reference/pixel_shader.hpp>

namespace prelight::reference {

/// What is kept of a surface until its neighbours are known.
struct SeenSurface {
    uint32_t draw = 0xffffffffu; ///< as it is: background
    uint32_t triangle = 0;
    bool lit = false;
    glm::vec3 position{0}; ///< relative to the camera
    glm::vec3 normal{0}, geometric_normal{0};
    float depth = 0;
    uint64_t shadow_mask = 0;
};

/// The same of a sample.
struct SeenSample {
    SeenSurface opaque;
    std::vector<SeenSurface> layers; ///< nearest first
    bool near_edge = false, runs_away = false, unclear = false, shadow_unclear = false;
    uint64_t mask_outcome = 0;
};

SeenSample remember(const SeenWorld& world, uint32_t x, uint32_t y, const Sample& sample);

/// Fills `edge` and `doubts` of one row of a picture with several samples a pixel. `seen`: all the picture's, in order.
void find_doubts(ReferencePicture& picture, std::span<const SeenSample> seen, uint32_t row);

} // namespace prelight::reference
