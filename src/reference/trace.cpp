#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <optional>
#include <parallel/parallel_for.hpp>
#include <prelight/error.hpp>
#include <reference/decals.hpp>
#include <reference/light_tree.hpp>
#include <reference/lighting.hpp>
#include <reference/ray_scene.hpp>
#include <reference/surface.hpp>
#include <reference/trace.hpp>
#include <reference/visibility.hpp>

namespace prelight::reference {
namespace {

constexpr uint32_t no_instance = 0xffffffffu;

/// Rays through pixel centres, relative to the camera's position. A ray's direction has length 1
/// along the camera's axis, so that distances along a ray are depths.
class Lens {
public:
    Lens(const PlacedCamera& placed, uint32_t width, uint32_t height)
        : placed_(placed), width_(width), height_(height) {
        const Camera& camera = placed.camera;
        half_height_ = camera.kind == ProjectionKind::perspective ? std::tan(camera.yfov / 2) : camera.ymag;
        half_width_ = half_height_ * width / height;
    }

    Ray ray(uint32_t x, uint32_t y) const {
        const Camera& camera = placed_.camera;
        const double across = (2 * (x + 0.5) / width_ - 1) * half_width_;
        const double up = (1 - 2 * (y + 0.5) / height_) * half_height_;
        const glm::dvec3 offset = placed_.axes[0] * across + placed_.axes[1] * up;
        if (camera.kind == ProjectionKind::perspective)
            return {glm::dvec3(0), offset - placed_.axes[2], camera.znear, camera.zfar};
        return {offset, -placed_.axes[2], camera.znear, camera.zfar};
    }

    /// Metres that a pixel covers across the view at this depth.
    double pixel(double depth) const {
        return 2 * half_height_ / height_ * (placed_.camera.kind == ProjectionKind::perspective ? depth : 1);
    }

private:
    const PlacedCamera& placed_;
    double width_, height_, half_width_ = 1, half_height_ = 1;
};

/// Where the hit point of the triangle was at the moment's previous state, relative to the scene's
/// origin.
glm::dvec3 previous_position(const Draw& draw, const Hit& hit) {
    const Primitive& primitive = *draw.primitive;
    if (primitive.previous_positions.empty() && draw.previous_to_world == draw.to_world)
        return hit.position; // exactly: what stands still has no motion, not even by rounding
    const auto& places = primitive.previous_positions.empty() ? primitive.positions : primitive.previous_positions;
    const glm::dvec3 place = interpolate(places, draw, hit.triangle, hit.weights);
    return glm::dvec3(draw.previous_to_world * glm::dvec4(place, 1));
}

class Tracer {
public:
    Tracer(const World& world, const PlacedCamera& camera, uint32_t width, uint32_t height, double exposure,
           const ReferenceForm& form, ReferenceBuffers* buffers)
        : form_(form), textures_(*world.scene, form.bilinear_level0), world_(world),
          scene_(world, camera.position, textures_), lights_(world, camera.position),
          environment_(world.scene->environment.get()), lens_(camera, width, height), origin_(camera.position),
          ambient_(world.ambient), factor_(std::exp2(exposure)), buffers_(buffers) {
        if (!world.decals.empty())
            decals_.emplace(world, camera.position, textures_);
        const size_t pixels = size_t(width) * height;
        picture.linear = Image(width, height);
        picture.instance.assign(pixels, no_instance);
        picture.primitive.assign(pixels, no_instance);
        picture.position.assign(pixels, glm::dvec3(0));
        picture.previous_position.assign(pixels, glm::dvec3(0));
        picture.normal.assign(pixels, glm::dvec3(0));
        picture.geometric_normal.assign(pixels, glm::dvec3(0));
        picture.depth.assign(pixels, std::numeric_limits<double>::infinity());
        picture.shadow_mask.assign(pixels, 0);
        picture.mask_outcome.assign(pixels, 0);
        if (!buffers)
            return;
        buffers->albedo = buffers->diffuse_light = buffers->specular_light = Image(width, height);
        buffers->light_count.assign(pixels, 0);
        buffers->visibility = buffers->visibility_radius > 0 ? Image(width, height) : Image();
        for (glm::vec3& one : buffers->visibility.pixels)
            one = glm::vec3(1);
    }

    void trace_row(uint32_t y) {
        std::vector<uint32_t> reached;
        for (uint32_t x = 0; x < picture.linear.width; ++x)
            trace_pixel(x, y, reached);
    }

    ReferencePicture picture;

private:
    void trace_pixel(uint32_t x, uint32_t y, std::vector<uint32_t>& reached) {
        const size_t at = size_t(y) * picture.linear.width + x;
        const Ray ray = lens_.ray(x, y);
        Hit hit;
        const bool found = scene_.closest(ray, hit);
        picture.mask_outcome[at] = hit.mask_outcome;
        if (!found) {
            if (environment_.is_background())
                picture.linear.pixels[at] = glm::vec3(environment_.background(glm::normalize(ray.direction)) * factor_);
            return;
        }
        const Draw& draw = scene_.draw(hit.draw);
        std::optional<Beside> beside;
        if (!form_.bilinear_level0)
            beside = Beside{scene_.beside(hit, lens_.ray(x ^ 1, y)), scene_.beside(hit, lens_.ray(x, y ^ 1))};
        Surface surface =
            evaluate_surface(scene_, textures_, hit, glm::normalize(-ray.direction), beside ? &*beside : nullptr);
        const double spread = form_.specular_antialiasing && !surface.unlit
                                  ? normal_spread(surface.normal, normal_at(hit, x ^ 1, y), normal_at(hit, x, y ^ 1))
                                  : 0; // of the surface itself
        if (decals_ && world_.instances[draw.instance].receives_decals && draw.material->receives_decals)
            decals_->cover(surface);
        set_lamp_roughness(surface, spread);
        if (form_.occlusion_radius > 0)
            surface.visibility = ray_visibility(scene_, hit, surface.normal, form_.occlusion_radius);
        if (buffers_ && buffers_->visibility_radius > 0)
            buffers_->visibility.pixels[at] =
                glm::vec3(form_.occlusion_radius == buffers_->visibility_radius
                              ? surface.visibility
                              : ray_visibility(scene_, hit, surface.normal, buffers_->visibility_radius));
        picture.instance[at] = draw.instance;
        picture.primitive[at] = draw.primitive_index;
        picture.position[at] = origin_ + hit.position;
        picture.previous_position[at] = origin_ + previous_position(draw, hit);
        picture.normal[at] = surface.normal;
        picture.geometric_normal[at] = hit.geometric_normal;
        picture.depth[at] = hit.distance;

        Lighting lighting(form_, surface, factor_, environment_.there() ? &environment_ : nullptr);
        if (!surface.unlit) {
            const double pixel =
                lens_.pixel(hit.distance) / std::max(std::abs(glm::dot(surface.normal, surface.view)), 0.1);
            lights_.reach(surface.position, reached);
            for (const uint32_t index : reached) {
                const Incident light = lights_.incident(index, surface.position, pixel);
                if (lighting.cosine(light) <= 0 || light.radiance == glm::dvec3(0))
                    continue;
                if (form_.shadows && light.casts_shadow && shadowed(hit, light))
                    picture.shadow_mask[at] += (index + uint64_t(1)) * 0x9e3779b97f4a7c15u;
                else
                    lighting.add(light);
            }
        }
        if (buffers_) {
            buffers_->albedo.pixels[at] = glm::vec3(surface.base_colour);
            buffers_->diffuse_light.pixels[at] = glm::vec3(lighting.sums().diffuse);
            buffers_->specular_light.pixels[at] = glm::vec3(lighting.sums().specular);
            buffers_->light_count[at] = lighting.sums().contributing;
        }
        picture.linear.pixels[at] = glm::vec3(lighting.radiance(ambient_) * factor_);
    }

    /// The normal that the triangle, its plane going on beyond its edges, has under another pixel.
    glm::dvec3 normal_at(const Hit& hit, uint32_t x, uint32_t y) const {
        const Ray ray = lens_.ray(x, y);
        return shading_normal(scene_, textures_, scene_.beside(hit, ray), glm::normalize(-ray.direction));
    }

    bool shadowed(const Hit& hit, const Incident& light) const {
        const glm::dvec3 start = hit.position + hit.geometric_normal * hit.offset;
        return scene_.blocked({start, light.to_light, 0, light.distance - hit.offset});
    }

    ReferenceForm form_;
    Textures textures_;
    const World& world_;
    RayScene scene_;
    std::optional<Decals> decals_; ///< absent: the world has none
    LightTree lights_;
    EnvironmentLight environment_;
    Lens lens_;
    glm::dvec3 origin_, ambient_;
    double factor_;
    ReferenceBuffers* buffers_;
};

} // namespace

ReferencePicture trace(const World& world, const PlacedCamera& camera, uint32_t width, uint32_t height, double exposure,
                       const ReferenceForm& form, ReferenceBuffers* buffers) {
    if (width == 0 || height == 0 || width > 65536 || height > 65536)
        throw Error(fmt::format("reference: a picture of {}x{} pixels is not rendered", width, height));
    Tracer tracer(world, camera, width, height, exposure, form, buffers);
    parallel_for(height, [&](uint32_t row) { tracer.trace_row(row); });
    return std::move(tracer.picture);
}

} // namespace prelight::reference

namespace prelight {

ReferencePicture render_reference(const World& world, const PlacedCamera& camera, uint32_t width, uint32_t height,
                                  double exposure, const ReferenceForm& form) {
    return reference::trace(world, camera, width, height, exposure, form);
}

} // namespace prelight
