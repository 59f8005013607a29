#include "words.hpp"
#include <pybind11/stl.h>

namespace prelight::python {
namespace {

void bind_parts(py::module_& module) {
    py::class_<Spread>(module, "Spread", "Times of several frames, milliseconds.")
        .def_readonly("min", &Spread::min, "Milliseconds.")
        .def_readonly("median", &Spread::median, "Milliseconds.")
        .def_readonly("max", &Spread::max, "Milliseconds.")
        .def("__repr__", [](const Spread& s) {
            return py::str("Spread(min={:.3f}, median={:.3f}, max={:.3f})").format(s.min, s.median, s.max);
        });
    py::class_<PassStats>(module, "PassStats", "One pass of the frame.")
        .def_readonly("name", &PassStats::name, "As debug labels have it.")
        .def_readonly("gpu_ms", &PassStats::gpu_ms, "Time on the device.")
        .def_readonly("cpu_ms", &PassStats::cpu_ms, "CPU time of the process; None without Renderer(pass_cpu=True).")
        .def_readonly("bytes_read", &PassStats::bytes_read, "Of the frame's images, each whole.")
        .def_readonly("bytes_written", &PassStats::bytes_written, "Of the frame's images, each whole.")
        .def("__repr__", [](const PassStats& p) {
            return py::str("PassStats({!r}, gpu_ms={:.3f})").format(p.name, p.gpu_ms.median);
        });
    py::class_<SettingChoice>(module, "SettingChoice", "A setting that has not the value asked for.")
        .def_readonly("key", &SettingChoice::key, "The setting.")
        .def_readonly("asked", &SettingChoice::asked, "By the user, the preset or the default.")
        .def_readonly("taken", &SettingChoice::taken, "In force.")
        .def_readonly("why", &SettingChoice::why, "A phrase.")
        .def("__repr__", [](const SettingChoice& c) {
            return py::str("SettingChoice({!r}, asked={!r}, taken={!r}, why={!r})")
                .format(c.key, c.asked, c.taken, c.why);
        });
    py::class_<CreatedObjects>(module, "CreatedObjects", "What the driver was made to make.")
        .def_readonly("allocations", &CreatedObjects::allocations, "Of device memory.")
        .def_readonly("pipelines", &CreatedObjects::pipelines, "How many.")
        .def_readonly("buffers", &CreatedObjects::buffers, "How many.")
        .def_readonly("images", &CreatedObjects::images, "How many.")
        .def_readonly("descriptor_pools", &CreatedObjects::descriptor_pools, "How many.");
    py::class_<HostTimes>(module, "HostTimes", "CPU time of the calling thread for one frame.")
        .def_readonly("lights", &HostTimes::lights, "Records of lights.")
        .def_readonly("culling", &HostTimes::culling, "Which lights reach what.")
        .def_readonly("objects", &HostTimes::objects, "Records of objects.")
        .def_readonly("record", &HostTimes::record, "Recording and submitting.");
}

void bind_optional_parts(py::module_& module) {
    py::class_<ShadowStats>(module, "ShadowStats", "What the shadow maps took (docs/shadows.md).")
        .def_readonly("budget", &ShadowStats::budget, "Texels that there are.")
        .def_readonly("texels", &ShadowStats::texels, "Of them, in a tile.")
        .def_readonly("lights", &ShadowStats::lights, "With a shadow.")
        .def_readonly("lights_reduced", &ShadowStats::lights_reduced, "Of these, for which the budget was short.")
        .def_readonly("lights_without", &ShadowStats::lights_without, "That should have a shadow and have none.")
        .def_readonly("smallest", &ShadowStats::smallest, "Side of a tile, texels.")
        .def_readonly("largest", &ShadowStats::largest, "Side of a tile, texels.")
        .def_readonly("tiles_drawn", &ShadowStats::tiles_drawn, "In the last frame.")
        .def_readonly("tiles_reused", &ShadowStats::tiles_reused, "In the last frame.")
        .def_readonly("casters_drawn", &ShadowStats::casters_drawn, "Objects in the tiles that were drawn.");
    py::class_<LightBufferStats>(module, "LightBufferStats", "What a light buffer in fixed point made of the light.")
        .def_readonly("diffuse_scale", &LightBufferStats::diffuse_scale, "The largest light that the sum holds.")
        .def_readonly("specular_scale", &LightBufferStats::specular_scale, "The largest light that the sum holds.")
        .def_readonly("clipped_pixels", &LightBufferStats::clipped_pixels, "With a channel at the largest value.");
    py::class_<InferredStats>(module, "InferredStats", "What inferred lighting made of the frame (docs/inferred.md).")
        .def_readonly("layers", &InferredStats::layers, "Draws of blended objects with a slot.")
        .def_readonly("layers_without_slot", &InferredStats::layers_without_slot, "Of them, that share one.")
        .def_readonly("unmatched_pixels", &InferredStats::unmatched_pixels, "For which no texel shows their surface.");
    py::class_<LayerStats>(module, "LayerStats", "Blended surfaces over the pixels (docs/transparency.md).")
        .def_readonly("most", &LayerStats::most, "Over one pixel.")
        .def_readonly("mean", &LayerStats::mean, "Of all pixels.")
        .def_readonly("exact", &LayerStats::exact, "Layers of a pixel that are composed one by one.")
        .def_readonly("approximate", &LayerStats::approximate, "Surfaces beyond these, over all pixels.");
}

} // namespace

void bind_stats(py::module_& module) {
    bind_parts(module);
    bind_optional_parts(module);
    py::class_<Stats>(module, "Stats", "What the last Renderer.render() did.")
        .def_readonly("device", &Stats::device, "Its name.")
        .def_readonly("driver", &Stats::driver, "Name and version.")
        .def_readonly("settings", &Stats::settings, "Every setting with the value in force.")
        .def_readonly("choices", &Stats::choices, "Settings that have not the value asked for, and why.")
        .def_readonly("shading", &Stats::shading, "In force.")
        .def_readonly("notes", &Stats::notes, "What the device could not give as asked for, one line each.")
        .def_readonly("lights", &Stats::lights, "Of the world.")
        .def_readonly("triangles", &Stats::triangles, "Of the world.")
        .def_readonly("triangles_drawn", &Stats::triangles_drawn, "Of them, what the first pass sends to the device.")
        .def_readonly("triangles_skipped", &Stats::triangles_skipped, "Of those, not drawn again; None: not known.")
        .def_readonly("draws", &Stats::draws, "Of the world.")
        .def_readonly("draws_skipped", &Stats::draws_skipped, "Of those, not drawn again; None: not known.")
        .def_readonly("frames", &Stats::frames, "That the times are of.")
        .def_readonly("wall_ms", &Stats::wall_ms, "Wall time of a frame.")
        .def_readonly("cpu_ms", &Stats::cpu_ms, "CPU time of the process, user and system.")
        .def_readonly("gpu_ms", &Stats::gpu_ms, "Time on the device.")
        .def_readonly("passes", &Stats::passes, "In the order in which they run.")
        .def_readonly("attachment_bytes", &Stats::attachment_bytes, "Memory of the frame's images.")
        .def_readonly("attachment_bytes_unshared", &Stats::attachment_bytes_unshared,
                      "The same if none shared memory with another.")
        .def_readonly("device_bytes", &Stats::device_bytes, "All memory on the device.")
        .def_readonly("device_bytes_peak", &Stats::device_bytes_peak, "The most since the device was made.")
        .def_readonly("updated_bytes", &Stats::updated_bytes, "Uploaded for what changed of the world, last frame.")
        .def_readonly("frame_bytes", &Stats::frame_bytes, "Written for the last frame alone.")
        .def_readonly("created", &Stats::created, "During the last frame: nothing, once all has been drawn.")
        .def_readonly("host_ms", &Stats::host_ms, "None for renderers without a device.")
        .def_readonly("shadows", &Stats::shadows, "None without shadows.")
        .def_readonly("light_buffer", &Stats::light_buffer, "None unless it is in fixed point.")
        .def_readonly("inferred", &Stats::inferred, "None but for the renderer inferred.")
        .def_readonly("layers", &Stats::layers, "None where blended surfaces are not drawn layer by layer.")
        .def_readonly("pairs_counted", &Stats::pairs_counted, "Whether the next two were (Renderer(count_pairs=True)).")
        .def_readonly("pairs_evaluated", &Stats::pairs_evaluated, "Pairs of a light and a pixel.")
        .def_readonly("pairs_contributing", &Stats::pairs_contributing,
                      "Of them, those where the light reached the pixel.")
        .def("__repr__", [](const Stats& s) {
            return py::str("Stats(device={!r}, lights={}, triangles={}, frames={}, wall_ms={:.3f}, gpu_ms={:.3f})")
                .format(s.device, s.lights, s.triangles, s.frames, s.wall_ms.median, s.gpu_ms.median);
        });
}

} // namespace prelight::python
