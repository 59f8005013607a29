#pragma once
#include <list>
#include <prelight/reference.hpp>
#include <string>
#include <utility>

namespace prelight::app {

/// "ggx, Fresnel weighted", "phong, monochrome specular light": for people.
std::string form_name(const ReferenceForm& form);

/// The reference's picture in each form that is asked for, each made once.
class References {
public:
    struct Picture {
        Image linear;
        std::vector<uint8_t> left_out;
    };
    /// `world` must outlive this.
    References(const World& world, const PlacedCamera& camera, const RenderOptions& options)
        : world_(world), camera_(camera), options_(options) {}
    /// Throws Error.
    const Picture& of(const ReferenceForm& form);

private:
    const World& world_;
    PlacedCamera camera_;
    RenderOptions options_;
    std::list<std::pair<ReferenceForm, Picture>> made_;
};

} // namespace prelight::app
