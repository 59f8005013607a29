// Whether the cells of light lists are cut into depth slices.
#ifndef PRELIGHT_SLICED_GLSL
#define PRELIGHT_SLICED_GLSL
#include "shared/bindings.h"
#include "shared/light_lists.h"

layout(constant_id = CONSTANT_LIST_SLICED) const bool sliced = false;
#endif
