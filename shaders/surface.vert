#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/surface_vertex.glsl"
