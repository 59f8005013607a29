#pragma once
#include <optional>
#include <prelight/renderer.hpp>

namespace prelight::app {

/// Looks at a scene in a small picture, before the picture itself is drawn: by the light pre-pass, whichever
/// architecture draws it in the end, so that all get the same; without a device by the reference.
class Meter {
public:
    /// `options` are the command's: their shading and tone curve, and whether there are shadows and ambient occlusion,
    /// count too; their exposure does not. The camera must outlive this.
    Meter(Device* device, const PlacedCamera& camera, const RenderOptions& options);

    /// Takes the picture that the other functions tell of. The world must outlive them.
    void look(const World& world);
    /// What `--exposure auto` is for it: its surfaces' luminances.
    double exposure();
    /// Share of the surfaces brighter than white at EV 0, before the tone curve bends them below it.
    double over_white() const;
    /// Share of the picture that a display shows black at this exposure.
    double black(double ev) const;

private:
    void draw(double ev);
    Image linear_at(double ev) const;

    Device* device_;
    const PlacedCamera& camera_;
    RenderOptions small_;
    std::unique_ptr<Renderer> renderer_; ///< for small_
    const World* world_ = nullptr;
    Image linear_; ///< with small_.exposure
    std::vector<bool> surface_;
    std::optional<double> exposure_; ///< once it is known
};

} // namespace prelight::app
