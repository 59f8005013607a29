// Which kinds of lights the frame may hold: code for the others is specialised away.
#ifndef PRELIGHT_LIGHT_KINDS_GLSL
#define PRELIGHT_LIGHT_KINDS_GLSL
#include "shared/bindings.h"

layout(constant_id = CONSTANT_LIGHT_KINDS) const uint light_kinds = LIGHT_KINDS_ALL;

bool may_be(uint kind) { return (light_kinds & kind) != 0u; }
#endif
