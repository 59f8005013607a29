#include "light_model.hpp"
#include <shared/bindings.h>

namespace prelight::passes {

gpu::Constants LightModel::constants() const {
    return {{CONSTANT_SHADING, shading == Shading::ggx ? SHADING_GGX : SHADING_PHONG},
            {CONSTANT_MODEL, static_cast<uint32_t>(fresnel)},
            {CONSTANT_PACKED_LIGHT, packed()},
            {CONSTANT_SPECULAR_WAY, static_cast<uint32_t>(specular)},
            {CONSTANT_SPECULAR_STEP_GATE, step_gate},
            {CONSTANT_REFLECTION_VECTOR, reflection_vector},
            {CONSTANT_AMBIENT_AS_LIGHT, ambient_as_light}};
}

} // namespace prelight::passes
