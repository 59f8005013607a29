#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <parallel/parallel_for.hpp>
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>
#include <reference/doubts.hpp>
#include <reference/trace.hpp>
#include <reference/visibility.hpp>

namespace prelight::reference {
namespace {

constexpr uint32_t no_instance = 0xffffffffu;

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

/// The form without what has no effect in it.
ReferenceForm plain_form(ReferenceForm form) {
    if (std::ranges::count(sample_counts, form.samples.count) == 0)
        throw Error(fmt::format("reference: {} samples a pixel: not one of {}", form.samples.count,
                                fmt::join(sample_counts, ", ")));
    if (form.half_samples && form.samples.count != 4)
        throw Error(
            fmt::format("reference: layers in half of {} samples a pixel: there have to be 4", form.samples.count));
    if (form.samples.count == 1)
        form.samples = {};
    if (form.inferred_scale != 0 && (form.inferred_scale < 0.125 || form.inferred_scale > 1))
        throw Error(
            fmt::format("reference: light at {} of the picture's size: 1/8 … 1 is rendered", form.inferred_scale));
    if (form.inferred_scale > 0 && form.samples.count > 1)
        throw Error("reference: light at a lower resolution has one sample a pixel");
    return form;
}

class Tracer {
public:
    Tracer(const World& world, const PlacedCamera& camera, uint32_t width, uint32_t height, double exposure,
           const ReferenceForm& form, ReferenceBuffers* buffers)
        : form_(plain_form(form)), world_(world, camera, width, height, form_), origin_(camera.position),
          ambient_(world.ambient), factor_(std::exp2(exposure)), buffers_(buffers) {
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
        picture.samples = form_.samples.count;
        row_layers_.resize(form_.transparency == ReferenceForm::Transparency::layers ? height : 0);
        if (!row_layers_.empty())
            picture.layer_count.assign(pixels, 0);
        if (picture.samples > 1) {
            picture.sample_colours.assign(pixels * picture.samples, glm::vec3(0));
            picture.edge.assign(pixels, 0);
            picture.doubts.assign(pixels, 0);
            seen_.resize(pixels * picture.samples);
        }
        if (form_.inferred_scale > 0) {
            inferred_.emplace(world, camera, width, height, form_, factor_);
            picture.doubts.assign(pixels, 0);
        }
        if (!buffers)
            return;
        buffers->albedo = buffers->diffuse_light = buffers->specular_light = Image(width, height);
        buffers->light_count.assign(pixels, 0);
        for (auto& [number, image] : buffers->layers)
            image = Image(width, height);
        for (auto& [number, one] : buffers->samples)
            one = {std::vector<double>(pixels, std::numeric_limits<double>::infinity()),
                   std::vector<glm::dvec3>(pixels, glm::dvec3(0))};
        buffers->visibility = buffers->visibility_radius > 0 ? Image(width, height) : Image();
        for (glm::vec3& one : buffers->visibility.pixels)
            one = glm::vec3(1);
    }

    /// Before rows: the light that has a resolution of its own.
    void light() {
        if (!inferred_)
            return;
        parallel_for(inferred_->rows(), [&](uint32_t row) { inferred_->light_row(row); });
        inferred_->find_doubts();
    }

    /// Something shows the picture behind it, which comes first then.
    bool looks_behind() const { return world_.rays().transmits(); }
    void trace_behind(uint32_t y) {
        PixelShader shader(world_, form_, ambient_, factor_, lights_elsewhere());
        for (uint32_t x = 0; x < picture.linear.width; ++x)
            picture.linear.at(x, y) = glm::vec3(shader.shade_opaque(x, y));
    }
    /// Once all rows are there.
    void blur_behind() { behind_.emplace(picture.linear); }

    void trace_row(uint32_t y) {
        PixelShader shader(world_, form_, ambient_, factor_, lights_elsewhere(), behind_ ? &*behind_ : nullptr);
        for (uint32_t x = 0; x < picture.linear.width; ++x) {
            const std::span<const Sample> samples = shader.shade(x, y);
            const size_t at = size_t(y) * picture.linear.width + x;
            put_surface(at, samples[0]);
            const std::span<const Sample> layers =
                samples.size() > 1 && samples[1].layer ? samples.subspan(1, 1) : std::span(samples[0].layers);
            for (const Sample& layer : layers)
                row_layers_[y].push_back(layer_of(layer));
            if (!row_layers_.empty())
                picture.layer_count[at] = static_cast<uint32_t>(layers.size());
            picture.linear.pixels[at] = samples[0].colour;
            show_layers(at, samples);
            show_samples(at, samples);
            if (inferred_) {
                bool unclear = samples[0].light_unclear;
                for (const Sample& layer : samples[0].layers)
                    unclear = unclear || layer.light_unclear;
                picture.doubts[at] = unclear ? ReferencePicture::inferred : 0;
            }
            if (samples.size() == 1)
                continue;
            glm::dvec3 sum(0);
            for (size_t i = 0; i < samples.size(); ++i) {
                sum += glm::dvec3(picture.sample_colours[at * samples.size() + i] = samples[i].colour);
                seen_[at * samples.size() + i] = remember(world_, x, y, samples[i]);
            }
            picture.linear.pixels[at] = glm::vec3(sum / static_cast<double>(samples.size()));
        }
    }

    void compare_row(uint32_t y) { find_doubts(picture, seen_, y); }

    /// Once all rows are there.
    void gather_layers() {
        for (const std::vector<ReferenceLayer>& row : row_layers_)
            picture.layers.insert(picture.layers.end(), row.begin(), row.end());
        if (picture.layers.empty())
            picture.layer_count.clear();
    }

    ReferencePicture picture;

private:
    void put_surface(size_t at, const Sample& sample) {
        const Hit& hit = sample.hit;
        picture.mask_outcome[at] = hit.mask_outcome;
        if (!sample.found)
            return;
        const Draw& draw = world_.rays().draw(hit.draw);
        picture.instance[at] = draw.instance;
        picture.primitive[at] = draw.primitive_index;
        picture.position[at] = origin_ + hit.position;
        picture.previous_position[at] = origin_ + previous_position(draw, hit);
        picture.normal[at] = sample.surface.normal;
        picture.geometric_normal[at] = hit.geometric_normal;
        picture.depth[at] = hit.distance;
        picture.shadow_mask[at] = sample.shadow_mask;
        if (!buffers_)
            return;
        buffers_->albedo.pixels[at] = glm::vec3(sample.base_colour);
        buffers_->diffuse_light.pixels[at] = glm::vec3(sample.sums.diffuse);
        buffers_->specular_light.pixels[at] = glm::vec3(sample.sums.specular);
        buffers_->light_count[at] = sample.sums.contributing;
        const double radius = buffers_->visibility_radius;
        if (radius > 0)
            buffers_->visibility.pixels[at] =
                glm::vec3(form_.occlusion_radius == radius && form_.samples.light != ReferenceSamples::Light::fragment
                              ? sample.surface.visibility
                              : ray_visibility(world_.rays(), hit, sample.surface.normal, radius));
    }

    void show_layers(size_t at, std::span<const Sample> samples) {
        if (!buffers_)
            return;
        for (auto& [number, image] : buffers_->layers)
            for (const Sample& sample : samples)
                if (number <= sample.layers.size()) {
                    const Sample& layer = sample.layers[number - 1];
                    image.pixels[at] +=
                        display_light(static_cast<float>(layer.surface.alpha) * layer.colour, buffers_->curve) /
                        static_cast<float>(samples.size());
                }
    }

    void show_samples(size_t at, std::span<const Sample> samples) {
        if (!buffers_)
            return;
        for (auto& [number, one] : buffers_->samples)
            if (const Sample& sample = samples[number]; sample.found) {
                one.depth[at] = sample.hit.distance;
                one.normal[at] = sample.surface.normal;
            }
    }

    ReferenceLayer layer_of(const Sample& layer) const {
        const Draw& draw = world_.rays().draw(layer.hit.draw);
        return {.instance = draw.instance,
                .primitive = draw.primitive_index,
                .depth = layer.hit.distance,
                .alpha = layer.surface.alpha,
                .position = origin_ + layer.hit.position,
                .normal = layer.surface.normal,
                .geometric_normal = layer.hit.geometric_normal,
                .shadow_mask = layer.shadow_mask};
    }

    const InferredLight* lights_elsewhere() const { return inferred_ ? &*inferred_ : nullptr; }

    ReferenceForm form_;
    SeenWorld world_;
    glm::dvec3 origin_{0}, ambient_{0};
    double factor_;
    std::optional<InferredLight> inferred_;
    std::optional<Behind> behind_;                        ///< where something looks behind
    std::vector<SeenSample> seen_;                        ///< of several samples a pixel
    std::vector<std::vector<ReferenceLayer>> row_layers_; ///< empty: BLEND is opaque
    ReferenceBuffers* buffers_;
};

} // namespace

ReferencePicture trace(const World& world, const PlacedCamera& camera, uint32_t width, uint32_t height, double exposure,
                       const ReferenceForm& form, ReferenceBuffers* buffers) {
    if (width == 0 || height == 0 || width > 65536 || height > 65536)
        throw Error(fmt::format("reference: a picture of {}x{} pixels is not rendered", width, height));
    Tracer tracer(world, camera, width, height, exposure, form, buffers);
    tracer.light();
    if (tracer.looks_behind()) {
        parallel_for(height, [&](uint32_t row) { tracer.trace_behind(row); });
        tracer.blur_behind();
    }
    parallel_for(height, [&](uint32_t row) { tracer.trace_row(row); });
    tracer.gather_layers();
    if (tracer.picture.samples > 1)
        parallel_for(height, [&](uint32_t row) { tracer.compare_row(row); });
    return std::move(tracer.picture);
}

} // namespace prelight::reference

namespace prelight {

Image ReferencePicture::display(Tonemap curve) const {
    if (samples == 1)
        return tonemap(linear, curve);
    Image out(linear.width, linear.height);
    for (size_t i = 0; i < out.pixels.size(); ++i) {
        glm::dvec3 sum(0);
        for (size_t s = i * samples; s < (i + 1) * samples; ++s)
            sum += glm::dvec3(display_light(sample_colours[s], curve));
        for (int channel = 0; channel < 3; ++channel)
            out.pixels[i][channel] = srgb_encode(static_cast<float>(sum[channel] / samples));
    }
    return out;
}

ReferencePicture render_reference(const World& world, const PlacedCamera& camera, uint32_t width, uint32_t height,
                                  double exposure, const ReferenceForm& form) {
    return reference::trace(world, camera, width, height, exposure, form);
}

} // namespace prelight
