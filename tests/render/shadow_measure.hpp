#pragma once
#include "against_reference.hpp"

namespace prelight {

/// What of a picture with shadows is wrong, beyond the filter's reach from where the reference's shadow rays
/// change their outcome.
struct ShadowErrors {
    double judged = 0;   ///< share of the picture's pixels that lie so
    double darkened = 0; ///< share of them that are darker than the reference by more than 2/255
    double leaking = 0;  ///< share of the picture's pixels that are lit by more than half, although something that is
                         ///< more than 2 cm away shadows them. Worlds with one light only
    double lit = 0,
           shadowed = 0; ///< share of the picture that the light reaches, and would; worlds with one light only
};

/// `reach`: pixels. Display-encoded values are compared.
ShadowErrors shadow_errors(Device& device, const Shot& shot, int reach);

/// EXPECTs the bounds of docs/shadows.md, printing the figures.
void expect_shadows_right(const Shot& shot, int reach);

} // namespace prelight
