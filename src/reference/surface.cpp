#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <reference/surface.hpp>

namespace prelight::reference {
namespace {

constexpr double roughness_min = 0.089;

class PointReader {
public:
    PointReader(const Textures& textures, const Draw& draw, const Hit& hit)
        : textures_(textures), draw_(draw), hit_(hit) {}

    template <typename Vector>
    auto attribute(const std::vector<Vector>& values) const {
        return interpolate(values, draw_, hit_.triangle, hit_.weights);
    }
    glm::dvec4 texture(const TextureRef& ref, Encoding encoding) const {
        const auto& uvs = draw_.primitive->texcoords[ref.texcoord & 1];
        return textures_.sample(ref, uvs.empty() ? glm::dvec2(0) : attribute(uvs), encoding);
    }

private:
    const Textures& textures_;
    const Draw& draw_;
    const Hit& hit_;
};

/// The normal of the side that the material means as front.
glm::dvec3 shading_normal(const PointReader& read, const Draw& draw, const Hit& hit) {
    const Primitive& primitive = *draw.primitive;
    const glm::dvec3 flat = hit.back ? -hit.geometric_normal : hit.geometric_normal;
    if (primitive.normals.empty())
        return flat;
    const glm::dvec3 interpolated = draw.normal_to_world * read.attribute(primitive.normals);
    const double length = glm::length(interpolated);
    if (!(length > 0)) // opposite normals met in the middle
        return flat;
    const glm::dvec3 normal = interpolated / length;
    const Material& material = *draw.material;
    if (!material.normal_texture || primitive.tangents.empty())
        return normal;

    const glm::dvec4 object_tangent = read.attribute(primitive.tangents);
    const glm::dvec3 along = glm::dmat3(draw.to_world) * glm::dvec3(object_tangent);
    if (!(glm::length(along) > 0))
        return normal;
    const glm::dvec3 tangent = glm::normalize(along);
    // A cross product turns round under a mirror; the sign turns it back, so that a mirrored
    // instance is the mirror image of the original.
    const double handedness = (object_tangent.w < 0 ? -1 : 1) * (draw.mirrored ? -1 : 1);
    const glm::dvec3 bitangent = handedness * glm::cross(normal, tangent);
    const glm::dvec3 texel =
        2.0 * glm::dvec3(read.texture(material.normal_texture, Encoding::linear)) - 1.0;
    const double scale = material.normal_scale;
    const glm::dvec3 bent =
        tangent * (texel.x * scale) + bitangent * (texel.y * scale) + normal * texel.z;
    return glm::length(bent) > 0 ? glm::normalize(bent) : normal;
}

} // namespace

Surface evaluate_surface(const RayScene& scene, const Textures& textures, const Hit& hit,
                         glm::dvec3 view) {
    const Draw& draw = scene.draw(hit.draw);
    const Material& material = *draw.material;
    const PointReader read(textures, draw, hit);

    Surface surface;
    surface.position = hit.position;
    surface.view = view;
    surface.normal = shading_normal(read, draw, hit) * (hit.back ? -1.0 : 1.0);
    surface.base_colour = glm::dvec3(scene.base_colour(draw, hit.triangle, hit.weights));
    surface.unlit = material.unlit;

    surface.metallic = material.metallic;
    surface.roughness = material.roughness;
    if (const TextureRef& ref = material.metallic_roughness_texture) {
        const glm::dvec4 texel = read.texture(ref, Encoding::linear);
        surface.roughness *= texel.g;
        surface.metallic *= texel.b;
    }
    surface.roughness = std::max(surface.roughness, roughness_min);
    if (const TextureRef& ref = material.occlusion_texture)
        surface.occlusion = 1 + static_cast<double>(material.occlusion_strength) *
                                    (read.texture(ref, Encoding::linear).r - 1);
    surface.emissive = material.emissive;
    if (const TextureRef& ref = material.emissive_texture)
        surface.emissive *= glm::dvec3(read.texture(ref, Encoding::srgb));
    return surface;
}

} // namespace prelight::reference
