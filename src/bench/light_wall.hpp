#pragma once
#include <map>
#include <prelight/image.hpp>
#include <prelight/reference.hpp>
#include <prelight/scene.hpp>

namespace prelight::bench {

/// A white metal wall before the camera, in three stripes of different roughness. Each of its lights
/// reaches all of it, so that every pixel has exactly that many. The brightest channel of the diffuse
/// sum is `peak`.
class LightWall {
public:
    LightWall(uint32_t lights, uint32_t width, uint32_t height);
    LightWall(const LightWall&) = delete;
    LightWall& operator=(const LightWall&) = delete;
    static constexpr double peak = 0.95;

    const World& world() const { return world_; }
    const PlacedCamera& camera() const { return world_.cameras[0]; }
    /// Of the reference: Σ N·L·R, and the specular sum's luminance with the material's exponent.
    const Image& diffuse() const { return diffuse_; }
    const Image& specular(ReferenceForm::Specular way) const { return specular_.at(way); }

private:
    void add_stripes();
    void add_lights(uint32_t count);
    Scene scene_;
    World world_;
    Image diffuse_;
    std::map<ReferenceForm::Specular, Image> specular_;
};

} // namespace prelight::bench
