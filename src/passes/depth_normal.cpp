#include "depth_normal.hpp"
#include "depth_only.hpp"
#include "hidden_geometry.hpp"
#include "layer_draws.hpp"
#include "surface_draws.hpp"
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <prelight/error.hpp>
#include <shared/normal_encoding.h>

namespace prelight::passes {
namespace {

/// By the value of a setting. Throws UsageError listing all.
template <class Info>
const Info& find_named(std::span<const Info> all, const char* key, std::string_view name) {
    std::vector<std::string_view> names;
    for (const Info& info : all) {
        if (info.name == name)
            return info;
        names.push_back(info.name);
    }
    throw UsageError(fmt::format("{}={}: allowed is {}", key, name, fmt::join(names, ", ")));
}

/// View depth in a colour target, or in the next one where the device lacks it. Sets `source` to what was
/// taken.
graph::ImageId linear_depth_target(graph::FrameGraph& graph, const gpu::Raster& raster, DepthSource& source) {
    const std::span<const DepthSourceInfo> chain = depth_sources();
    const auto first =
        std::find_if(chain.begin(), chain.end(), [&](const DepthSourceInfo& info) { return info.source == source; });
    std::vector<VkFormat> formats;
    for (auto info = first; info != chain.end(); ++info)
        formats.push_back(info->format);
    const graph::ImageId image = graph.image("linear depth", raster, formats);
    const VkFormat taken = graph.desc(image).format;
    source =
        std::find_if(first, chain.end(), [&](const DepthSourceInfo& info) { return info.format == taken; })->source;
    return image;
}

/// Of several samples a pixel's lights see one, which has stencil.
bool needs_stencil(const resident::View& view, const SurfaceFormat& format) {
    return format.stencil && view.surface_raster().samples == 1;
}

/// The first of two geometry passes: depth, and linear depth when a colour target holds it.
void depth_pass(graph::FrameGraph& graph, const resident::View& view, SurfaceBuffers& out) {
    if (out.format.depth == DepthSource::attachment) {
        out.depth = out.depth_source = depth_only_pass(graph, view, needs_stencil(view, out.format));
        return;
    }
    out.depth = make_depth(graph, view.surface_raster(), needs_stencil(view, out.format));
    out.depth_source = linear_depth_target(graph, view.surface_raster(), out.format.depth);
    graph::Pass& pass = graph.pass("depth");
    pass.depth_write(out.depth).colour(out.depth_source, graph::Load::clear);
    draw_surfaces(graph, pass, view,
                  {.name = "depth",
                   .fragment = {"depth_normal.frag", gpu::Variant::no_normal_target | gpu::Variant::depth_target},
                   .constants = out.format.constants(),
                   .vertex = gpu::Variant::no_normal});
    hidden_geometry_passes(graph, view, out.depth);
}

} // namespace

std::span<const NormalEncodingInfo> normal_encodings() {
    using Encoding = NormalEncoding;
    static const std::array all{
        NormalEncodingInfo{Encoding::oct24, "oct24", 24, {VK_FORMAT_R8G8B8A8_UNORM}},
        NormalEncodingInfo{Encoding::oct32, "oct32", 32, {VK_FORMAT_R16G16_UNORM, VK_FORMAT_R32G32_SFLOAT}},
        NormalEncodingInfo{
            Encoding::rgb10a2, "rgb10a2", 30, {VK_FORMAT_A2B10G10R10_UNORM_PACK32, VK_FORMAT_R8G8B8A8_UNORM}},
        NormalEncodingInfo{Encoding::rgb8, "rgb8", 24, {VK_FORMAT_R8G8B8A8_UNORM}},
        NormalEncodingInfo{Encoding::spherical, "spherical", 24, {VK_FORMAT_R8G8B8A8_UNORM}},
        NormalEncodingInfo{Encoding::oct16, "oct16", 16, {VK_FORMAT_R8G8_UNORM, VK_FORMAT_R8G8B8A8_UNORM}},
        NormalEncodingInfo{Encoding::xy16f, "xy16f", 32, {VK_FORMAT_R16G16_SFLOAT, VK_FORMAT_R32G32_SFLOAT}}};
    return all;
}

std::span<const DepthSourceInfo> depth_sources() {
    static constexpr std::array all{DepthSourceInfo{DepthSource::attachment, "attachment", VK_FORMAT_D32_SFLOAT},
                                    DepthSourceInfo{DepthSource::r32f, "r32f", VK_FORMAT_R32_SFLOAT},
                                    DepthSourceInfo{DepthSource::r16f, "r16f", VK_FORMAT_R16_SFLOAT},
                                    DepthSourceInfo{DepthSource::rgba8, "rgba8", VK_FORMAT_R8G8B8A8_UNORM}};
    return all;
}

const NormalEncodingInfo& find_normal_encoding(std::string_view name) {
    return find_named(normal_encodings(), "normals", name);
}

const DepthSourceInfo& find_depth_source(std::string_view name) { return find_named(depth_sources(), "depth", name); }

gpu::Constants SurfaceFormat::constants() const {
    return {{CONSTANT_NORMAL_ENCODING, static_cast<uint32_t>(normals)},
            {CONSTANT_NORMAL_SPACE, view_space},
            {CONSTANT_DEPTH_SOURCE, static_cast<uint32_t>(depth)},
            {CONSTANT_POSITION_FROM_RAY, position_from_ray},
            {CONSTANT_GBUFFER, static_cast<uint32_t>(gbuffer)},
            {CONSTANT_SPECULAR_ANTIALIASING, specular_antialiasing}};
}

graph::ImageId make_depth(graph::FrameGraph& graph, const gpu::Raster& raster, bool stencil) {
    return stencil ? graph.image("depth", raster, {VK_FORMAT_D32_SFLOAT_S8_UINT, VK_FORMAT_D24_UNORM_S8_UINT})
                   : graph.image("depth", {VK_FORMAT_D32_SFLOAT, raster});
}

SurfaceBuffers depth_normal_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceFormat& format) {
    const gpu::Raster& raster = view.surface_raster();
    SurfaceBuffers out{format};
    if (format.two_passes)
        depth_pass(graph, view, out);
    else
        out.depth = out.depth_source = make_depth(graph, raster, needs_stencil(view, format));

    gpu::Variants variants;
    graph::Pass& pass = graph.pass(format.two_passes ? "normal" : "depth-normal");
    if (!format.two_passes)
        pass.depth_write(out.depth);
    else if (!format.roughness_in_stencil)
        pass.depth_test(out.depth);
    for (const NormalEncodingInfo& info : normal_encodings())
        if (info.encoding == format.normals)
            out.normal = out.roughness = graph.image("normal", raster, info.formats);
    pass.colour(out.normal, graph::Load::clear);
    if (format.roughness_in_stencil) {
        (format.two_passes ? pass.stencil(out.depth) : pass).keeps_stencil(graph::Load::clear);
        variants |= gpu::Variant::stencil_roughness;
    } else if (!shared::normal_holds_roughness(static_cast<int>(format.normals))) {
        out.roughness = graph.image("roughness", raster, {VK_FORMAT_R16_SFLOAT, VK_FORMAT_R32_SFLOAT});
        pass.colour(out.roughness, graph::Load::clear);
        variants |= gpu::Variant::roughness_target;
    }
    if (!format.two_passes && format.depth != DepthSource::attachment) {
        out.depth_source = linear_depth_target(graph, raster, out.format.depth);
        pass.colour(out.depth_source, graph::Load::clear);
        variants |= gpu::Variant::depth_target;
    }
    if (format.ids) {
        out.ids = graph.image("surface ids", {VK_FORMAT_R32G32_UINT, raster});
        pass.colour(out.ids, graph::Load::clear);
        variants |= gpu::Variant::surface_ids;
    }
    draw_surfaces(graph, pass, view,
                  {.name = pass.name(),
                   .fragment = {"depth_normal.frag", variants},
                   .constants = out.format.constants(),
                   .depth = format.two_passes ? gpu::DepthTest::equal : gpu::DepthTest::write_nearer,
                   .keeps_alpha_mask = !format.two_passes,
                   .vertex = gpu::when(!variants.has(gpu::Variant::depth_target), gpu::Variant::no_world) |
                             gpu::when(format.ids, gpu::Variant::surface_ids) | gpu::Variant::no_textures});
    if (!format.two_passes)
        hidden_geometry_passes(graph, view, out.depth);
    return out;
}

void layer_geometry_pass(graph::FrameGraph& graph, const resident::View& view, const SurfaceBuffers& surface) {
    graph::Pass& pass = graph.pass("geometry layers");
    pass.depth_write(surface.depth, graph::Load::keep)
        .colour(surface.normal, graph::Load::keep)
        .colour(surface.ids, graph::Load::keep);
    draw_layers(pass, view,
                {.name = pass.name(),
                 .fragment = {"depth_normal.frag", gpu::Variant::surface_ids | gpu::Variant::layer},
                 .constants = surface.format.constants(),
                 .vertex = gpu::Variant::surface_ids | gpu::Variant::no_world | gpu::Variant::no_textures,
                 .layer_decals = view.layer_decals() != nullptr},
                view);
}

} // namespace prelight::passes
