#pragma once
#include <array>
#include <reference/inferred_light.hpp>
#include <reference/seen_world.hpp>
#include <reference/shared_surface.hpp>
#include <reference/transmission.hpp>

namespace prelight::reference {

inline constexpr uint32_t most_samples = sample_counts.back();

/// What one ray of a pixel saw, and what became of it.
struct Sample {
    glm::dvec2 place = pixel_centre;
    Ray ray;
    Hit hit; ///< without `found` only its mask_outcome
    bool found = false;
    /// [ReferenceForm::half_samples] What it shows of what its ray meets.
    enum class Shows { all, opaque, nearest } shows = Shows::all;
    bool layer = false; ///< the hit is a layer, seen as if it were opaque
    double alpha = 1;   ///< of the material that gave the colour
    uint32_t owner = 0; ///< the pixel's first sample on the same triangle
    Surface surface;    ///< as lights see it
    bool lit = false;   ///< lights were evaluated for it, at a place of its own
    uint64_t shadow_mask = 0;
    bool unclear = false;        ///< whether it shares a surface with others of the pixel: too close to a limit
    bool shadow_unclear = false; ///< that of all the pixel's samples
    bool light_unclear = false;  ///< which light of a lower resolution it gets is too close to a limit
    bool runs_away = false;      ///< its triangle's plane does not lie before the camera under the pixel's centre
    glm::vec3 colour{0};         ///< exposed scene-linear
    glm::dvec3 base_colour{0};   ///< of the material that gave the colour
    LightSums inferred;          ///< what it finds at the light's own resolution
    LightSums sums;              ///< which that material met
    std::vector<Sample> layers;  ///< blended surfaces in front of it, nearest first; its colour shows them
};

/// Leaves of what the ray through this place of the pixel met what a sample shows. Returns whether `hit` is a layer
/// now.
bool leave_shown(const SeenWorld& world, Sample::Shows shows, uint32_t x, uint32_t y, glm::dvec2 place, bool& found,
                 Hit& hit, std::vector<Hit>& layers);

/// Casts a pixel's rays and shades what they hit, in the form's own way.
class PixelShader {
public:
    /// `ambient`: radiance from everywhere; `factor`: exposure. `form` has nothing but defaults in `samples` where
    /// there is one. `inferred`: where lights are not evaluated at the pixel's samples, but found there; null: they
    /// are. `behind`: the picture that shade_opaque() makes, where something is transmissive.
    PixelShader(const SeenWorld& world, const ReferenceForm& form, glm::dvec3 ambient, double factor,
                const InferredLight* inferred = nullptr, const Behind* behind = nullptr)
        : world_(world), form_(form), layer_form_(form), ambient_(ambient), factor_(factor), inferred_(inferred),
          behind_(behind) {
        layer_form_.own_shaders = ReferenceForm::OwnShaders::sums; // drawn with all lights at once, whatever is below
    }

    /// The pixel's samples, in Vulkan's order. They stay until the next call.
    std::span<const Sample> shade(uint32_t x, uint32_t y);
    /// The same without what is blended or transmissive: their mean, exposed.
    glm::dvec3 shade_opaque(uint32_t x, uint32_t y);

private:
    void shade_surfaces();
    static bool at_fragments(ReferenceSamples::Rate rate) { return rate == ReferenceSamples::Rate::fragment; }
    std::span<Sample> samples() { return std::span(samples_).first(form_.samples.count); }
    void look(bool at_layers);
    void take_surfaces(uint32_t index);
    Sample centre_of(const Sample& owner) const;
    Shared share(const Sample& first, const Sample& other, const Likeness& likeness) const;
    bool are_one_surface();
    void choose_pixel();
    void choose_edges();
    bool several_triangles() const;
    void doubt_shadows();
    template <class Which>
    double mean_depth(const Which& which) const;
    Sample& point_of(const Sample& sample);
    void occlude(Sample& point, bool layer = false) const;
    glm::vec3 behind(const Sample& sample) const;
    /// Where lights are evaluated, and how much of the mean they are there.
    struct Point {
        Sample* sample;
        double share;
    };
    Lighting shine(const ReferenceForm& form, const Surface& material, std::span<const Point> points,
                   bool shadows_at_pixel);
    void shade_material(const Surface& material, uint32_t owner, std::span<Sample*> targets);
    void lay_over(uint32_t index);
    void lay_over_halves();
    Sample layer_at(uint32_t index, const Hit& hit);

    const SeenWorld& world_;
    const ReferenceForm& form_;
    ReferenceForm layer_form_; ///< of layers
    glm::dvec3 ambient_{0};
    double factor_;
    const InferredLight* inferred_;
    const Behind* behind_;
    uint32_t x_ = 0, y_ = 0;
    Ray centre_ray_;
    std::array<Sample, most_samples> samples_;
    std::array<std::vector<Hit>, most_samples> layers_; ///< what their rays went through
    std::array<Sample, most_samples> centres_;          ///< of fragments, by owner: the place under the pixel's centre
    Sample pixel_;                                      ///< the pixel's one place, for light or shadows once a pixel
    bool one_surface_ = false;                          ///< all samples share one
    std::array<Sample, most_samples> edges_;            ///< of an edge pixel's surfaces, by their first samples
    std::array<uint32_t, most_samples> edge_;           ///< of each sample, which of them
    std::vector<uint32_t> reached_;
};

} // namespace prelight::reference
