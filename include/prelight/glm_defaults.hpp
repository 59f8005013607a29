#pragma once
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <type_traits>

// glm's types are part of the interface, as glm has them by default. Its options change how they lie in memory and how
// functions receive them, so a program built with them would not fit the library.
#ifdef GLM_FORCE_QUAT_DATA_WXYZ
#error "Prelight is built without GLM_FORCE_QUAT_DATA_WXYZ"
#endif

namespace prelight {

static_assert(std::is_trivially_copyable_v<glm::vec3> && std::is_trivially_copyable_v<glm::dvec3>,
              "Prelight is built without GLM_FORCE_CTOR_INIT");
static_assert(sizeof(glm::vec3) == 12 && alignof(glm::vec4) == 4 && alignof(glm::dvec3) == 8,
              "Prelight is built without GLM_FORCE_DEFAULT_ALIGNED_GENTYPES");

} // namespace prelight
