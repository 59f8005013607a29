// Weights of weighted blended transparency: McGuire and Bavoil, "Weighted Blended Order-Independent Transparency", JCGT
// 2(2), 2013. The same text is compiled as C++ and as GLSL.
#ifndef PRELIGHT_BLENDED_WEIGHT_H
#define PRELIGHT_BLENDED_WEIGHT_H
#include "shared/interop.h"
SHARED_BEGIN

// What one layer may add to a sum of half floats, of which the largest is 65504: that of 64 layers is finite.
#define BLENDED_MOST_OF_A_LAYER 1000.0f

// How much a layer at view depth `z` (metres) counts for the mean colour of all layers: equation (7), times alpha once
// more, for this is what the sums take of its colour and of 1. Equation (7) tells layers of rooms and streets apart, and
// needs no far plane as equation (10) does. `largest`: of the colour's channels; a layer so bright that the sums would not
// hold it counts for less, and by itself is still exact.
SHARED_FUNCTION float blended_weight(float z, float alpha, float largest) {
    float near = z / 5.0f, far = z / 200.0f;
    float of_depth = 10.0f / (1e-5f + near * near + far * far * far * far * far * far);
    float weight = alpha * alpha * max(1e-2f, min(of_depth, 3e3f));
    return min(weight, BLENDED_MOST_OF_A_LAYER / max(largest, 1.0f));
}

SHARED_END
#endif
