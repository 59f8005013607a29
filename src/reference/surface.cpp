#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <prelight/material_shader.hpp>
#include <reference/surface.hpp>

namespace prelight::reference {
namespace {

constexpr double roughness_min = 0.089;

class PointReader {
public:
    TexcoordShift shift{}; ///< parallax
    PointReader(const Textures& textures, const Draw& draw, const Hit& hit, const Beside* beside)
        : textures_(textures), draw_(draw), hit_(hit), beside_(beside) {}

    template <typename Vector>
    auto attribute(const std::vector<Vector>& values) const {
        return interpolate(values, draw_, hit_.triangle, hit_.weights);
    }
    glm::dvec4 texture(const TextureRef& ref, Encoding encoding) const {
        return textures_.sample(ref,
                                texcoords(draw_, hit_.triangle, hit_.weights, ref.texcoord) + shift[ref.texcoord & 1],
                                encoding, footprint(draw_, hit_, beside_, ref.texcoord));
    }
    const Draw& draw() const { return draw_; }
    const Hit& hit() const { return hit_; }

private:
    const Textures& textures_;
    const Draw& draw_;
    const Hit& hit_;
    const Beside* beside_;
};

/// A triangle's edges from its first corner, and what one of its texture-coordinate sets does along them.
struct Edges {
    glm::dvec3 side[2]{};
    glm::dmat2 texcoords{1}; ///< a column for each edge
    Edges(const PointReader& read, uint32_t set) {
        const Draw& draw = read.draw();
        const uint32_t* index = &draw.primitive->indices[size_t(read.hit().triangle) * 3];
        const auto corner = [&](int i) {
            return glm::dvec3(draw.to_world * glm::dvec4(draw.primitive->positions[index[i]], 1));
        };
        const auto at = [&](double b, double c) {
            return reference::texcoords(draw, read.hit().triangle, {1 - b - c, b, c}, set);
        };
        side[0] = corner(1) - corner(0);
        side[1] = corner(2) - corner(0);
        texcoords = glm::dmat2(at(1, 0) - at(0, 0), at(0, 1) - at(0, 0));
    }
};

/// Directions along a texture and off the surface, on the side that the material means as front.
struct Frame {
    glm::dvec3 tangent{0}, bitangent{0}, normal{0};
    bool has_tangents = false;
    glm::dvec3 to_world(glm::dvec3 v) const {
        const glm::dvec3 bent = tangent * v.x + bitangent * v.y + normal * v.z;
        return glm::length(bent) > 0 ? glm::normalize(bent) : normal;
    }
};

Frame frame_of(const PointReader& read, const Draw& draw, const Hit& hit) {
    const Primitive& primitive = *draw.primitive;
    Frame frame;
    frame.normal = hit.back ? -hit.geometric_normal : hit.geometric_normal;
    if (primitive.normals.empty())
        return frame;
    const glm::dvec3 interpolated = draw.normal_to_world * read.attribute(primitive.normals);
    const double length = glm::length(interpolated);
    if (!(length > 0)) // opposite normals met in the middle
        return frame;
    frame.normal = interpolated / length;
    if (primitive.tangents.empty())
        return frame;
    const glm::dvec4 object_tangent = read.attribute(primitive.tangents);
    const glm::dvec3 along = glm::dmat3(draw.to_world) * glm::dvec3(object_tangent);
    if (!(glm::length(along) > 0))
        return frame;
    frame.tangent = glm::normalize(along);
    // A cross product turns round under a mirror; the sign turns it back, so that a mirrored
    // instance is the mirror image of the original.
    const double handedness = (object_tangent.w < 0 ? -1 : 1) * (draw.mirrored ? -1 : 1);
    frame.bitangent = handedness * glm::cross(frame.normal, frame.tangent);
    frame.has_tangents = true;
    return frame;
}

/// The normal map's normal in tangent space; (0, 0, 1) without one.
glm::dvec3 mapped_normal(const PointReader& read, const Material& material) {
    if (!material.normal_texture)
        return {0, 0, 1};
    const glm::dvec3 texel = 2.0 * glm::dvec3(read.texture(material.normal_texture, Encoding::linear)) - 1.0;
    const double scale = material.normal_scale;
    return {texel.x * scale, texel.y * scale, texel.z};
}

const TextureRef* own_map(const Material& material, const char* name) {
    const auto found = material.textures.find(name);
    return found == material.textures.end() || !found->second ? nullptr : &found->second;
}

double own_number(const Material& material, const char* name) {
    const auto found = material.parameters.find(name);
    return found == material.parameters.end() ? material.shader->find_parameter(name)->default_value.x
                                              : found->second.x;
}

/// The frame of a texture that is not the normal map: the same where it reads the same coordinates, else as its own run
/// over the triangle.
Frame frame_of_texture(const PointReader& read, const Material& material, const Frame& frame, const TextureRef& ref) {
    if (ref.texcoord == material.normal_texture.texcoord && ref.uv_linear == material.normal_texture.uv_linear)
        return frame;
    const Edges edges(read, ref.texcoord);
    const glm::dmat2 texels = glm::dmat2(ref.uv_linear) * edges.texcoords;
    const double area = glm::determinant(texels);
    if (area == 0)
        return frame;
    const glm::dmat2 inverse = glm::inverse(texels); // columns: how far along either edge u and v grow
    const glm::dvec3 u = inverse[0].x * edges.side[0] + inverse[0].y * edges.side[1];
    const glm::dvec3 v = inverse[1].x * edges.side[0] + inverse[1].y * edges.side[1];
    const glm::dvec3 flat = u - glm::dot(u, frame.normal) * frame.normal;
    if (!(glm::length(flat) > 0))
        return frame;
    Frame out = frame;
    out.tangent = glm::normalize(flat);
    out.bitangent = glm::cross(frame.normal, out.tangent);
    if (glm::dot(out.bitangent, v) > 0) // it points to smaller v
        out.bitangent = -out.bitangent;
    return out;
}

/// Where the texture moves by `shift`, how far each set moves.
TexcoordShift shifted(const PointReader& read, const TextureRef& ref, glm::dvec2 shift) {
    TexcoordShift out{};
    const glm::dmat2 linear(ref.uv_linear);
    if (glm::determinant(linear) == 0)
        return out;
    const uint32_t own = ref.texcoord & 1, other = own ^ 1;
    out[own] = glm::inverse(linear) * shift;
    const glm::dmat2 run = Edges(read, own).texcoords;
    if (glm::determinant(run) != 0)
        out[other] = Edges(read, other).texcoords * (glm::inverse(run) * out[own]);
    return out;
}

/// Where along the line of sight a ray that enters at depth 0 meets the relief: 0 the face, 1 the bottom.
double relief_depth(const PointReader& read, const TextureRef& heights, const TexcoordShift& whole, int steps) {
    const auto surface = [&](double depth) {
        PointReader there = read;
        there.shift = {whole[0] * depth, whole[1] * depth};
        return 1 - there.texture(heights, Encoding::linear).r;
    };
    if (steps < 1)
        return surface(0);
    double last = surface(0);
    for (int i = 1; i <= steps; ++i) {
        const double depth = double(i) / steps, now = surface(depth);
        if (now <= depth) { // the ray and the relief, both straight between two steps, cross
            const double before = last - double(i - 1) / steps, after = depth - now;
            return (i - 1 + before / std::max(before + after, 1e-6)) / steps;
        }
        last = now;
    }
    return 1;
}

/// The relief of `detailed`: moves where its textures are read.
void take_relief(PointReader& read, const Material& material, const Frame& frame, glm::dvec3 view, bool back) {
    const TextureRef* heights = own_map(material, "height_map");
    if (!heights)
        return;
    const double off = std::max(glm::dot(frame.normal, view) * (back ? -1 : 1), 0.05);
    const Frame own = frame_of_texture(read, material, frame, *heights);
    // Along the bitangent v falls.
    const TexcoordShift whole = shifted(read, *heights,
                                        own_number(material, "depth") / off *
                                            glm::dvec2(-glm::dot(own.tangent, view), glm::dot(own.bitangent, view)));
    const double depth = relief_depth(read, *heights, whole, int(own_number(material, "occlusion_steps")));
    read.shift = {whole[0] * depth, whole[1] * depth};
}

/// A parameter of `layered` times a channel of its map.
double layer_number(const PointReader& read, const Material& material, const char* name, const char* map, int channel) {
    const TextureRef* ref = own_map(material, map);
    return own_number(material, name) * (ref ? read.texture(*ref, Encoding::linear)[channel] : 1.0);
}

glm::dvec3 layer_colour(const PointReader& read, const Material& material, const char* name, const char* map) {
    const auto given = material.parameters.find(name);
    const glm::vec4 factor =
        given == material.parameters.end() ? material.shader->find_parameter(name)->default_value : given->second;
    const TextureRef* ref = own_map(material, map);
    return glm::dvec3(factor) * (ref ? glm::dvec3(read.texture(*ref, Encoding::srgb)) : glm::dvec3(1));
}

void take_layers(const PointReader& read, const Material& material, Surface& surface) {
    SurfaceLayers& out = surface.layers;
    out.ior = own_number(material, "ior");
    out.specular = layer_number(read, material, "specular", "specular_map", 3);
    out.specular_colour = layer_colour(read, material, "specular_colour", "specular_colour_map");
    out.clearcoat = layer_number(read, material, "clearcoat", "clearcoat_map", 0);
    const double coat_roughness = layer_number(read, material, "clearcoat_roughness", "clearcoat_roughness_map", 1);
    out.sheen_colour = layer_colour(read, material, "sheen_colour", "sheen_colour_map");
    out.sheen_roughness = layer_number(read, material, "sheen_roughness", "sheen_roughness_map", 3);
    out.body_roughness = surface.roughness;
    out.transmission = layer_number(read, material, "transmission", "transmission_map", 0);
    out.thickness = layer_number(read, material, "thickness", "thickness_map", 1) *
                    std::cbrt(std::abs(glm::determinant(glm::dmat3(read.draw().to_world))));
    out.shows_behind = read.draw().transmissive;
    out.attenuation_distance = own_number(material, "attenuation_distance");
    out.attenuation_colour = layer_colour(read, material, "attenuation_colour", "");
    out.coat_roughness = coat_roughness;
    surface.roughness += out.clearcoat * (coat_roughness - surface.roughness); // one sum of light for both
}

double brightness(glm::dvec3 c) { return std::sqrt(0.299 * c.r * c.r + 0.587 * c.g * c.g + 0.114 * c.b * c.b); }

/// KHR_materials_pbrSpecularGlossiness, and for lighting that knows no other the closest metallic-roughness:
/// metalness from the brightness of both colours, base colour from each channel (docs/materials.md).
void take_specular_glossiness(const PointReader& read, const Material& material, Surface& surface) {
    const TextureRef* ref = own_map(material, "specular_glossiness_map");
    const glm::dvec4 texel = ref ? read.texture(*ref, Encoding::srgb) : glm::dvec4(1);
    DiffuseAndSpecular& own = surface.specular_glossiness;
    own.f0 = layer_colour(read, material, "specular", "specular_glossiness_map");
    own.diffuse = surface.base_colour * (1 - std::max({own.f0.r, own.f0.g, own.f0.b}));
    surface.roughness = 1 - own_number(material, "glossiness") * texel.a;

    constexpr double dielectric = 0.04;
    const double reflected = brightness(own.f0), sum = brightness(own.diffuse) + reflected - 2 * dielectric;
    double& metallic = surface.metallic;
    metallic = 0;
    if (reflected > dielectric) {
        const double root = std::sqrt(std::max(sum * sum + 4 * dielectric * (reflected - dielectric), 0.0));
        metallic = std::clamp((root - sum) / (2 * dielectric), 0.0, 1.0);
    }
    const glm::dvec3 as_dielectric = own.diffuse / std::max(1 - metallic, 1e-4);
    const glm::dvec3 as_metal = (own.f0 - dielectric * (1 - metallic)) / std::max(metallic, 1e-4);
    surface.base_colour = glm::clamp(glm::mix(as_dielectric, as_metal, metallic * metallic), 0.0, 1.0);
}

bool is_detailed(const Material& material) { return material.shader && material.shader->name == "detailed"; }

/// How much of its details `detailed` shows.
double detail_share(const PointReader& read, const Material& material) {
    const TextureRef* mask = own_map(material, "detail_mask");
    return mask ? read.texture(*mask, Encoding::linear).r : 1.0;
}

/// The shading normal, with the normal map and what `detailed` adds to it.
glm::dvec3 bent_normal(const PointReader& read, const Material& material, const Frame& frame, bool back) {
    const double side = back ? -1 : 1;
    if (!frame.has_tangents)
        return frame.normal * side;
    const TextureRef* details = is_detailed(material) ? own_map(material, "detail_normal_map") : nullptr;
    if (!details)
        return (material.normal_texture ? frame.to_world(mapped_normal(read, material)) : frame.normal) * side;
    const glm::dvec3 detail = 2.0 * glm::dvec3(read.texture(*details, Encoding::linear)) - 1.0;
    const double amount = own_number(material, "detail") * detail_share(read, material);
    const glm::dvec3 base = mapped_normal(read, material);
    const Frame own = frame_of_texture(read, material, frame, *details);
    const glm::dvec3 bent = frame.tangent * base.x + frame.bitangent * base.y + frame.normal * base.z +
                            amount * (own.tangent * detail.x + own.bitangent * detail.y);
    return glm::normalize(bent) * side;
}

/// What `detailed` adds to a surface beside its normal.
void take_details(const PointReader& read, const Material& material, Surface& surface) {
    if (const TextureRef* ref = own_map(material, "detail_map")) {
        const glm::dvec3 factor = glm::dvec3(read.texture(*ref, Encoding::srgb)) / linear_of_srgb(128);
        const double amount = own_number(material, "detail_colour") * detail_share(read, material);
        surface.base_colour = glm::min(surface.base_colour * (1.0 + amount * (factor - 1.0)), glm::dvec3(1));
    }
    if (const TextureRef* ref = own_map(material, "gloss_map")) {
        surface.gloss = read.texture(*ref, Encoding::linear).r;
        surface.roughness += own_number(material, "gloss_roughness") * (1 - surface.gloss) * (1 - surface.roughness);
    }
    if (const TextureRef* ref = own_map(material, "incandescence_map"))
        surface.emissive += own_number(material, "incandescence") * glm::dvec3(read.texture(*ref, Encoding::srgb));
}

} // namespace

glm::dvec3 shading_normal(const RayScene& scene, const Textures& textures, const Hit& hit, glm::dvec3 view) {
    const Draw& draw = scene.draw(hit.draw);
    PointReader read(textures, draw, hit, nullptr);
    const Frame frame = frame_of(read, draw, hit);
    if (is_detailed(*draw.material) && frame.has_tangents)
        take_relief(read, *draw.material, frame, view, hit.back);
    return bent_normal(read, *draw.material, frame, hit.back);
}

double normal_spread(glm::dvec3 normal, glm::dvec3 across, glm::dvec3 down) {
    across -= normal;
    down -= normal;
    const double spread = 0.5 * (glm::dot(across, across) + glm::dot(down, down));
    return spread < 0.18 ? spread : 0.18; // what is no number, too
}

void set_lamp_roughness(Surface& surface, double spread) {
    const double own = surface.environment_roughness;
    const double seen = spread > 0 ? std::pow(std::min(std::pow(own, 4) + spread, 1.0), 0.25) : own;
    surface.roughness = std::max(seen, roughness_min);
}

Surface evaluate_surface(const RayScene& scene, const Textures& textures, const Hit& hit, glm::dvec3 view,
                         const Beside* beside) {
    const Draw& draw = scene.draw(hit.draw);
    const Material& material = *draw.material;
    PointReader read(textures, draw, hit, beside);
    const Frame frame = frame_of(read, draw, hit);
    const bool detailed = is_detailed(material);
    if (detailed && frame.has_tangents)
        take_relief(read, material, frame, view, hit.back);

    Surface surface;
    surface.position = hit.position;
    surface.view = view;
    surface.normal = bent_normal(read, material, frame, hit.back);
    const glm::dvec4 base = scene.base_colour(hit, read.shift, beside);
    surface.base_colour = glm::dvec3(base);
    surface.alpha = std::clamp(base.a, 0.0, 1.0);
    surface.unlit = material.unlit;
    surface.shaded = material.shader ? &material : nullptr;

    surface.metallic = material.metallic;
    surface.roughness = material.roughness;
    if (const TextureRef& ref = material.metallic_roughness_texture) {
        const glm::dvec4 texel = read.texture(ref, Encoding::linear);
        surface.roughness *= texel.g;
        surface.metallic *= texel.b;
    }
    if (const TextureRef& ref = material.occlusion_texture)
        surface.occlusion =
            1 + static_cast<double>(material.occlusion_strength) * (read.texture(ref, Encoding::linear).r - 1);
    surface.emissive = material.emissive;
    if (const TextureRef& ref = material.emissive_texture)
        surface.emissive *= glm::dvec3(read.texture(ref, Encoding::srgb));
    if (material.shader && material.shader->name == "layered")
        take_layers(read, material, surface);
    if (material.shader && material.shader->name == "specular-glossiness")
        take_specular_glossiness(read, material, surface);
    if (detailed)
        take_details(read, material, surface);
    surface.environment_roughness = surface.roughness;
    set_lamp_roughness(surface, 0);
    return surface;
}

} // namespace prelight::reference
