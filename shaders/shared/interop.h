// What C++ and GLSL both read. Members fill 16 bytes each, or a vec3 and the scalar after it do, so that std140,
// std430 and C++ lay them out alike.
#ifndef PRELIGHT_INTEROP_H
#define PRELIGHT_INTEROP_H
#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
#define SHARED_BEGIN namespace prelight::shared { using namespace glm;
#define SHARED_END }
#define SHARED_FUNCTION inline
#else
#define SHARED_BEGIN
#define SHARED_END
#define SHARED_FUNCTION
#endif
#endif
