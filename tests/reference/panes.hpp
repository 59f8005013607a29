#pragma once
#include "sampled.hpp"
#include <gtest/gtest.h>

namespace prelight {

/// A blended square that faces +Z, its colour its own light.
struct Pane {
    glm::vec3 colour{1};
    float alpha = 0.5f;
    double z = 0;
};

inline Material blended(glm::vec3 colour, float alpha) {
    return {.base_colour = glm::vec4(colour, alpha), .alpha_mode = AlphaMode::blend, .unlit = true};
}

inline Material unlit(glm::vec3 colour) { return {.base_colour = glm::vec4(colour, 1), .unlit = true}; }

inline glm::dmat4 at_height(double z) { return glm::translate(glm::dmat4(1), {0, 0, z}); }

inline const ReferenceForm in_layers{.transparency = ReferenceForm::Transparency::layers};

/// From the farthest to the nearest: `panes` are in this order.
inline glm::dvec3 laid_over(glm::dvec3 behind, const std::vector<Pane>& panes) {
    for (const Pane& pane : panes)
        behind = double(pane.alpha) * glm::dvec3(pane.colour) + (1 - double(pane.alpha)) * behind;
    return behind;
}

inline ReferencePicture in_metres(const TestWorld& test, const ReferenceForm& form = in_layers,
                                  ProjectionKind kind = ProjectionKind::orthographic) {
    return render_reference(test.world, metre_camera(kind), columns, rows, 0, form);
}

/// A picture all around, a texel's radiance by its number.
template <typename Radiance>
std::shared_ptr<Environment> surroundings(Radiance radiance) {
    auto environment = std::make_shared<Environment>();
    environment->image = Image(8, 4);
    for (size_t i = 0; i < environment->image.pixels.size(); ++i)
        environment->image.pixels[i] = radiance(i);
    return environment;
}

/// Within what a float holds.
inline void expect_colour(glm::vec3 got, glm::dvec3 wanted, const std::string& what) {
    EXPECT_LT(glm::length(glm::dvec3(got) - wanted), 1e-6 * (1 + glm::length(wanted)))
        << what << ": " << got.r << " " << got.g << " " << got.b << ", not " << wanted.r << " " << wanted.g << " "
        << wanted.b;
}

} // namespace prelight
