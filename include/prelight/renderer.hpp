#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <prelight/export.hpp>
#include <prelight/image.hpp>
#include <prelight/scene.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace prelight {

class Device;

/// A lighting model (docs/lighting-model.md).
enum class Shading {
    phong, ///< the source texts' model, Engel's equation 8.5.1, Blinn-Phong by default
    ggx,   ///< glTF 2.0 metallic-roughness
};

/// What RenderOptions::msaa may be, where the device has so many (Device::has_samples); the first is one.
inline constexpr std::array<uint32_t, 3> sample_counts{1, 2, 4};

/// What a renderer is made for.
struct RenderOptions {
    uint32_t width = 1280;                  ///< of the pictures, pixels
    uint32_t height = 720;                  ///< likewise
    std::optional<Shading> shading;         ///< absent: the preset's own, without one ggx; see shading_in_force()
    Tonemap tonemap = Tonemap::pbr_neutral; ///< from scene-linear values to the display's
    double exposure = 0;                    ///< EV: scene-linear values are multiplied by 2^exposure
    uint32_t msaa = 1;                      ///< samples a pixel: one of sample_counts
    bool count_pairs = false;               ///< fill Stats::pairs (slower)
    /// Fill PassStats::cpu_ms: after the timed frames as many more, each pass submitted alone.
    bool pass_cpu = false;
    std::string preset;                          ///< one of RendererInfo::presets; empty: none
    std::map<std::string, std::string> settings; ///< --set KEY=VALUE; checked by the renderer
    std::vector<std::string> views;              ///< buffers that `read` will be asked for
};

/// What a setting needs to have an effect.
struct SettingNeed {
    std::string key;                 ///< another setting, or "shading" or "msaa"
    std::vector<std::string> values; ///< that it may have
    std::string or_view{};           ///< or this view is asked for
    /// Whether the key is not a setting, but one of RenderOptions.
    bool of_options() const { return key == "shading" || key == "msaa"; }
};

/// One setting of a renderer, as `prelight renderers NAME` lists it.
struct SettingInfo {
    std::string key;                 ///< its name, as in RenderOptions::settings
    std::vector<std::string> values; ///< allowed words; an entry like "0.1 … 64" stands for a number
    std::string default_value;       ///< what it is when nobody says anything
    std::string description;         ///< one line
    /// All of them; a setting that the user changes without them is refused. Filled in by renderer_infos().
    std::vector<SettingNeed> needs{};
};

/// What there is to know of an architecture before one is made.
struct RendererInfo {
    std::string name;                  ///< as create_renderer() takes it
    std::string description;           ///< one line
    std::vector<SettingInfo> settings; ///< that it has
    std::vector<std::string> views;    ///< buffers that `read` can be asked for; see has_view()
    std::vector<std::string> presets;  ///< settings by one name
    /// What each preset sets; --set goes before it.
    std::map<std::string, std::map<std::string, std::string>> preset_settings{};
    bool needs_device = true; ///< create_renderer() wants a Device
    /// The lighting model of each preset's source text; one that is not named has no preference.
    std::map<std::string, Shading> preset_shading{};
};

/// The model that a renderer shades with: what was asked for, or the preset's, or ggx.
PRELIGHT_API Shading shading_in_force(const RendererInfo& info, const RenderOptions& options);

/// Of several times, milliseconds.
struct Spread {
    double min = 0;    ///< the shortest
    double median = 0; ///< the middle one, or the mean of the two in the middle
    double max = 0;    ///< the longest
};
/// Of samples in any order; all 0 without any.
PRELIGHT_API Spread spread(std::vector<double> samples);

/// Figures of one pass of the frame graph.
struct PassStats {
    std::string name; ///< as in debug labels
    Spread gpu_ms;    ///< by the device's timestamps
    /// By the formats of the frame's images: each that the pass reads or writes counts once, whole.
    /// An attachment that is cleared is written; one that is kept or blended is read and written.
    uint64_t bytes_read = 0;
    uint64_t bytes_written = 0; ///< likewise
    /// CPU time of the whole process (user + system, all threads) while the pass is recorded, submitted
    /// alone and waited for. Only with RenderOptions::pass_cpu; its frames are in no other figure.
    std::optional<Spread> cpu_ms = {};
};

/// What the host had the device's driver make.
struct CreatedObjects {
    uint64_t allocations = 0;      ///< of device memory
    uint64_t pipelines = 0;        ///< VkPipeline
    uint64_t buffers = 0;          ///< VkBuffer
    uint64_t images = 0;           ///< VkImage
    uint64_t descriptor_pools = 0; ///< VkDescriptorPool
    /// Member by member.
    bool operator==(const CreatedObjects&) const = default;
};

/// CPU time of one frame, milliseconds: the calling thread's, and of threads that help it.
struct HostTimes {
    Spread lights;  ///< the lights' records: what of each light shaders read; with the time of set_lights() and
                    ///< update_world()
    Spread culling; ///< which lights reach the picture or an object, in which group, with which bounds
    Spread objects; ///< the objects' records, and which of their triangles may show
    Spread record;  ///< recording and submitting the frame's commands
};

/// What the shadow maps of the last frame took (docs/shadows.md). A spot has one tile, or six where its
/// cone is wide; a point light six; a directional one four.
struct ShadowStats {
    uint64_t budget = 0;         ///< texels that there are
    uint64_t texels = 0;         ///< of them, in a tile
    uint64_t lights = 0;         ///< with a shadow
    uint64_t lights_reduced = 0; ///< of these, with less than a texel for eight pixels across: the budget was short
    uint64_t lights_without = 0; ///< that should have a shadow, and not even one texel a tile was left
    uint32_t smallest = 0;       ///< side of the smallest tile, texels
    uint32_t largest = 0;        ///< side of the largest tile, texels
    uint64_t tiles_drawn = 0;    ///< in the last frame
    uint64_t tiles_reused = 0;   ///< as they were: neither their light nor a caster moved
    uint64_t casters_drawn = 0;  ///< objects in the tiles that were drawn
};

/// What a light buffer in fixed point made of the last frame's light: codes are 0 … 1 times a scale.
struct LightBufferStats {
    double diffuse_scale = 0;    ///< the largest light that the diffuse sum holds
    double specular_scale = 0;   ///< the largest light that the specular sum holds
    uint64_t clipped_pixels = 0; ///< with a channel at the largest value: their light may have been more
};

/// What inferred lighting made of the last frame (docs/inferred.md).
struct InferredStats {
    uint64_t layers = 0;              ///< draws of blended objects that have a slot in the light's resolution
    uint64_t layers_without_slot = 0; ///< of them, those that share one with another that they may cover
    uint64_t unmatched_pixels = 0;    ///< pixels, of layers too, for which no texel around them shows their surface
};

/// Blended surfaces over the pixels of the last frame, before what is opaque. Of several samples a pixel each counts.
struct LayerStats {
    uint32_t most = 0;        ///< over one pixel
    double mean = 0;          ///< of all pixels
    uint32_t exact = 0;       ///< layers of a pixel that are composed in their order, one by one
    uint64_t approximate = 0; ///< surfaces beyond these, summed over all pixels
};

/// A setting that has not the value asked for: that was "auto", or what the device or other settings rule out.
struct SettingChoice {
    std::string key;   ///< the setting
    std::string asked; ///< by the user, the preset or the default
    std::string taken; ///< in its place
    std::string why;   ///< a phrase
};

/// Figures of the last Renderer::render().
struct Stats {
    std::string device;                          ///< Device::name()
    std::string driver;                          ///< Device::driver()
    std::map<std::string, std::string> settings; ///< every setting with the value in force
    std::vector<SettingChoice> choices;          ///< by key
    Shading shading = Shading::ggx;              ///< in force
    std::vector<std::string> notes;              ///< what the device could not give as asked for, one line each
    uint64_t lights = 0;                         ///< of the world, or of set_lights()
    uint64_t triangles = 0;                      ///< of the world
    uint64_t draws = 0;                          ///< of objects, in all passes of a frame
    uint64_t triangles_drawn = 0;                ///< of them, what the first pass over all geometry sends to the device
    /// What of that is not drawn again by later passes, because no pixel of it was left: draws by occlusion queries,
    /// triangles by the depth buffer. Without them nothing is known of it.
    std::optional<uint64_t> draws_skipped = {};
    std::optional<uint64_t> triangles_skipped = {}; ///< see draws_skipped
    uint32_t frames = 0;                            ///< that were rendered and timed
    /// Wall and CPU time go from the end of one frame to the end of the next, for one is prepared while
    /// another is drawn; a single frame's from the call of render().
    Spread wall_ms;
    Spread cpu_ms;                           ///< user and system time of all threads; see wall_ms
    Spread gpu_ms;                           ///< from a frame's first timestamp on the device to its last
    std::vector<PassStats> passes;           ///< in the order in which they run
    uint64_t attachment_bytes = 0;           ///< device memory of the frame's images
    uint64_t device_bytes = 0;               ///< all device memory that is held now
    uint64_t device_bytes_peak = 0;          ///< the most device memory held at once since the device was made
    CreatedObjects created;                  ///< during the last frame: nothing, once all has been drawn
    uint64_t updated_bytes = 0;              ///< what the last frame uploaded for update_world()
    uint64_t frame_bytes = 0;                ///< what the host wrote for the last frame alone: lights, objects, draws
    std::optional<HostTimes> host_ms = {};   ///< renderers on a device
    std::optional<ShadowStats> shadows = {}; ///< with shadows=on
    std::optional<LightBufferStats> light_buffer = {}; ///< of a target in fixed point
    std::optional<InferredStats> inferred = {};        ///< of the renderer `inferred`
    std::optional<LayerStats> layers = {};             ///< where blended surfaces are drawn layer by layer
    uint64_t attachment_bytes_unshared = 0;            ///< the same images, if none shared memory with another
    uint64_t pairs_evaluated = 0;                      ///< of a light and a pixel (or sample) that it was evaluated for
    uint64_t pairs_contributing = 0; ///< of them, those with attenuation and N·L above 0, in shadow or not
    bool pairs_counted = false;      ///< RenderOptions::count_pairs: else both are 0 and say nothing
};

/// A buffer of a frame in host memory, as the device has written it there: no copy of anything. It stays as it is,
/// whatever is rendered after it, until the last copy of this handle is gone, which must be before the device is.
struct Texels {
    /// How a texel lies in memory.
    enum class Format {
        rgba8,   ///< four bytes: display-encoded values × 255; alpha says nothing
        rgba16f, ///< four half floats
        rgba32f, ///< four floats
        rgb32f,  ///< three floats: renderers that need no device
    };
    uint32_t width = 0;                   ///< pixels
    uint32_t height = 0;                  ///< pixels
    Format format = Format::rgba8;        ///< of each texel
    std::span<const std::byte> bytes{};   ///< row by row from the top left, nothing between rows
    std::shared_ptr<const void> memory{}; ///< what `bytes` lies in
};

/// An architecture. Made for one set of options; shows any world that is given to it.
class PRELIGHT_API Renderer {
public:
    virtual ~Renderer() = default;
    /// Takes the world in (uploads it). `world` and its scene must stay alive, and unchanged but for what
    /// update_world() is told.
    virtual void set_world(const World& world) = 0;
    /// set_world() with the world that another renderer has. What that has uploaded of it is not uploaded again where
    /// both are on one device and want it alike there (exposure, texture filter, shadows, motion, blended materials …);
    /// lights, cameras, sizes and settings of their own they have in any case. Each is told by update_world() what has
    /// changed, before any of them renders; a change that costs as much as set_world() ends the sharing. Renderers that
    /// share are used by one thread at a time. Throws Error when the other has no world, and as set_world() does.
    virtual void share_world(const Renderer& other) = 0;
    /// Of set_world(), or null.
    virtual const World* world() const = 0;
    /// The caller has changed the world of set_world(), or its scene's materials, where they stand, and says what: from
    /// the next render() on the picture is that of the world as it is now. What moves, is shown or hidden, takes other
    /// vertices, factors or lights costs what it takes to upload that. What needs other draws or pipelines (a texture,
    /// an alpha mode, a transform that mirrors what was not mirrored, an object that comes under a decal for the first
    /// time, `all`) costs as much as set_world(). Ambient light is read for each picture and need not be told. Lights
    /// of set_lights() stay unless `changes.lights`. A read() needs another render() first. Throws Error: before
    /// set_world(), numbers that are not there, and as set_world() does; then the renderer has no world.
    virtual void update_world(const WorldChanges& changes) = 0;
    /// Takes other lights in place of the world's, from the next render() on: to move them, add and
    /// remove them. Cheaper than set_world(): geometry and materials stay, and pipelines too unless
    /// there are more lights than ever before, or a spot or another falloff comes in. A read() needs
    /// another render() first. Throws Error before set_world(), or when the device
    /// cannot hold so many.
    virtual void set_lights(std::span<const PlacedLight> lights) = 0;
    /// Pictures of another size, pixels, from the next render() on. Geometry, textures and the
    /// lights' maps stay on the device; images, lists of lights and shadow maps are rebuilt. A read() needs another
    /// render() first; stats() stay those of the last one. Throws Error when the size is 0 or more than the device
    /// takes, or when memory ends; the renderer is as before then.
    virtual void resize(uint32_t width, uint32_t height) = 0;
    /// Renders `frames` ≥ 1 frames. Where something was built since the last call, every pipeline is
    /// warmed first, by a frame of one pixel that counts in no figure. May come back while the device
    /// still draws: stats() and read() wait for it, and another set_lights() and render() need not.
    /// Throws Error, which may be that of a frame before.
    virtual void render(const PlacedCamera& camera, uint32_t frames = 1) = 0;
    /// A buffer of the last frame: "final" is display-encoded 0 … 1, "linear" is the exposed
    /// scene-linear picture, the others are drawn so that a person can read them (display-encoded).
    /// Only names in RenderOptions::views, and "final" and "linear". A "linear" that is not among them
    /// may draw the frame again, for a picture that nobody looks at is not kept; stats() stay those of
    /// render(). Throws UsageError.
    virtual Image read(std::string_view view) = 0;
    /// The same where it lies, instead of floats made of it. Throws as read() does.
    virtual Texels texels(std::string_view view) = 0;
    /// Figures of the last render(); waits for its frames. Throws Error.
    virtual Stats stats() const = 0;
    /// The most lights that a world may have here: what memory or the device's buffers hold.
    virtual uint64_t max_lights() const = 0;
};

/// All architectures that create_renderer() makes, the light pre-pass first.
PRELIGHT_API std::vector<RendererInfo> renderer_infos();
/// Makes one. `device` may be null for renderers that need none. Throws UsageError for an unknown name, setting
/// or combination; Error when the device cannot do it.
PRELIGHT_API std::unique_ptr<Renderer> create_renderer(std::string_view name, Device* device,
                                                       const RenderOptions& options);

} // namespace prelight
