#include "light_prepass_presets.hpp"

namespace prelight {

std::map<std::string, std::map<std::string, std::string>> light_prepass_presets() {
    return {
        // W. Engel, ShaderX7 8.5: equation 8.5.2 in one 8:8:8:8 target with a scale value; diffuse light as
        // luminance parts the specular term (ways 3 and 5: specular=fifth-channel, specular=bent);
        // world-space normals in spherical coordinates, 8:8:8; light volumes.
        {"engel",
         {{"normals", "spherical"},
          {"normal-space", "world"},
          {"light-buffer", "packed-rgba8"},
          {"specular", "luminance"},
          {"light-culling", "volumes"},
          {"specular-antialiasing", "off"}}},
        // M. Quandt, Light Pre-Pass Round 2: depth in a colour target (Single, HalfSingle, Color), world-space
        // normals in 10:10:10:2 (Color), R·V in alpha, frustum rays, ambient and directional lights full
        // screen, spheres, cones; no depth test, culling by the camera's place. With several samples a pixel, light
        // at one and materials at all.
        {"round2",
         {{"depth", "r32f"},
          {"normals", "rgb10a2"},
          {"normal-space", "world"},
          {"position", "ray"},
          {"light-buffer", "packed-rgba8"},
          {"specular", "stored"},
          {"specular-vector", "reflection"},
          {"ambient", "light"},
          {"light-culling", "volumes"},
          {"spot-volume", "cone"},
          {"volume-depth-test", "off"},
          {"msaa-light", "pixel"},
          {"msaa-material", "sample"},
          {"specular-antialiasing", "off"}}},
        // M. Lee, Prelighting: view-space normal in RGB and specular power in alpha of the memory that later
        // holds the frame (the frame graph sees to that), diffuse and specular light by MRT in 8:8:8:8
        // each (3.7 MB at 1280 × 720), one screen-space quad a light; shadow memory reused light by light.
        {"prelighting",
         {{"normals", "rgb8"},
          {"normal-space", "view"},
          {"light-buffer", "rgba8"},
          {"specular", "stored"},
          {"light-culling", "rectangles"},
          {"shadow-memory", "reuse"},
          {"specular-antialiasing", "off"}}},
    };
}

} // namespace prelight
