#pragma once
#include <array>
#include <deque>
#include <glm/mat3x3.hpp>
#include <memory>
#include <prelight/reference.hpp>
#include <prelight/scene.hpp>
#include <reference/texture.hpp>
#include <vector>

struct RTCFilterFunctionNArguments;

namespace prelight::reference {

/// A ray relative to the scene's origin. `direction` need not have unit length; distances along the
/// ray are multiples of it.
struct Ray {
    glm::dvec3 origin{0}, direction{0, 0, -1};
    double near = 0, far = std::numeric_limits<double>::infinity();
};

/// One primitive of one instance.
struct Draw {
    uint32_t instance, primitive_index;
    const Primitive* primitive;
    const Material* material;
    glm::dmat4 to_world{1};          ///< object → world, relative to the scene's origin
    glm::dmat4 previous_to_world{1}; ///< the same at the moment's previous state
    glm::dmat3 normal_to_world{1};   ///< inverse transpose, up to a positive factor
    bool mirrored;
    bool transmissive; ///< the picture behind it comes through; it throws no shadow
};

struct Hit {
    uint32_t draw = 0, triangle = 0;
    double distance = 0;            ///< along the ray
    glm::dvec3 weights{1, 0, 0};    ///< barycentric, of the triangle's three corners
    glm::dvec3 position{0};         ///< relative to the scene's origin
    glm::dvec3 geometric_normal{0}; ///< unit, facing the ray's origin
    bool back = false;              ///< the back face of a double-sided material
    double offset = 0;              ///< metres: how far a shadow ray starts off the surface
    uint64_t mask_outcome = 0;      ///< hash of the alpha tests that the ray met up to the hit
};

/// Where the rays of the pixels beside it in the row and column of its quad meet the plane of the triangle that was
/// hit.
struct Beside {
    Hit across, down;
};

/// What comes through along a shadow ray.
struct Passage {
    double transmittance = 1; ///< Π(1 − α) over blended surfaces; 0 where anything opaque is in the way
    uint64_t crossed = 0;     ///< hash of those blended surfaces; 0: none, or it makes no difference
};

/// Added to either texture-coordinate set.
using TexcoordShift = std::array<glm::dvec2, 2>;

/// The world's triangles in Embree. Vertices are made relative to `origin` (the camera) in double
/// precision before they are rounded to float, and a hit's place in its triangle is computed again
/// in double precision: 10 km from the world's origin nothing is lost.
/// Back faces of single-sided materials are not there, nor is a masked surface below its cutoff.
class RayScene {
public:
    using Transparency = ReferenceForm::Transparency;
    using TransparentShadows = ReferenceForm::TransparentShadows;
    /// `viewer`: right, up and backwards of the camera that is at `origin`, for what faces it (Primitive::facing).
    /// Throws Error when an index is out of range or Embree fails.
    RayScene(const World& world, glm::dvec3 origin, const Textures& textures,
             Transparency transparency = Transparency::opaque,
             TransparentShadows transparent_shadows = TransparentShadows::opaque,
             const glm::dmat3& viewer = glm::dmat3(1));
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    /// The nearest hit within [near, far]. Returns false when there is none. Layers are not hit. `layers`: set to those
    /// up to the hit, one that lies on it too, nearest first, at one distance by instance and primitive. A transmissive
    /// one is the last: what it shows is another ray's.
    bool closest(const Ray& ray, Hit& hit, std::vector<Hit>* layers = nullptr) const;
    /// Where another ray meets the plane of the triangle that was hit, on the triangle or not.
    Hit beside(const Hit& hit, const Ray& ray) const;
    /// What light comes through on the ray; here both faces of every triangle count.
    Passage passage(const Ray& ray) const;
    bool blocked(const Ray& ray) const { return passage(ray).transmittance == 0; }
    /// How far the nearest surface lies, of both faces, as a multiple of the direction; infinity: nothing. Layers do
    /// not count.
    double blocked_at(const Ray& ray) const;
    /// Some surface is Draw::transmissive.
    bool transmits() const { return transmits_; }
    const Draw& draw(uint32_t index) const { return draws_[index]; }
    size_t draw_count() const { return draws_.size(); }
    /// Base colour RGBA of a point: factor × texture × vertex colour. `shift` moves texture coordinates.
    glm::dvec4 base_colour(const Hit& hit, const TexcoordShift& shift = {}, const Beside* beside = nullptr) const;

private:
    struct Embree;
    void add(const Draw& draw, const World& world);
    /// Nearest first.
    std::vector<Hit> layers_until(const Ray& ray, double limit) const;
    void refine(const Ray& ray, Hit& hit, glm::dvec2 embree_weights, double embree_distance) const;
    /// Whether the material's mask has a hole there.
    bool masked_out(const Draw& draw, uint32_t triangle, glm::dvec2 place) const;
    static void filter(const RTCFilterFunctionNArguments* arguments);
    bool is_layer(const Draw& draw) const {
        return draw.transmissive ||
               (transparency_ == Transparency::layers && draw.material->alpha_mode == AlphaMode::blend);
    }

    const Textures& textures_;
    Transparency transparency_;
    TransparentShadows transparent_shadows_;
    bool has_layers_ = false, transmits_ = false;
    std::vector<Draw> draws_;
    std::deque<Primitive> faced_; ///< primitives that face the camera, as it sees them
    std::unique_ptr<Embree> embree_;
};

/// Value of an attribute at a point of a triangle.
template <typename Vector>
auto interpolate(const std::vector<Vector>& values, const Draw& draw, uint32_t triangle, glm::dvec3 weights) {
    using Result = glm::vec<Vector::length(), double>;
    const uint32_t* index = &draw.primitive->indices[size_t(triangle) * 3];
    return weights.x * Result(values[index[0]]) + weights.y * Result(values[index[1]]) +
           weights.z * Result(values[index[2]]);
}

/// Of a set at a point of a triangle; (0, 0) where the primitive has none.
inline glm::dvec2 texcoords(const Draw& draw, uint32_t triangle, glm::dvec3 weights, uint32_t set) {
    const auto& uvs = draw.primitive->texcoords[set & 1];
    return uvs.empty() ? glm::dvec2(0) : glm::dvec2(interpolate(uvs, draw, triangle, weights));
}

/// How far a set's coordinates run from the hit to what lies beside it; nothing without that.
inline Footprint footprint(const Draw& draw, const Hit& hit, const Beside* beside, uint32_t set) {
    if (!beside)
        return {};
    const auto at = [&](const Hit& other) { return texcoords(draw, hit.triangle, other.weights, set); };
    return {at(beside->across) - at(hit), at(beside->down) - at(hit)};
}

} // namespace prelight::reference
