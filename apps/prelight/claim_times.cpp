#include "claims.hpp"
#include "interleave.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <prelight/error.hpp>
#include <span>

namespace prelight::app {
namespace {

using Settings = std::map<std::string, std::string>;

/// A ratio below this is noise, not a difference.
constexpr double clearly = 1.05;

/// Renderers that are timed in turn, all of them in each round.
class Timing {
public:
    explicit Timing(const ClaimScene& scene) : scene_(scene) {}

    /// Returns the index for the figures below. `world` must outlive this.
    size_t add(const char* renderer, const World& world, size_t lights, const Settings& settings = {}) {
        RenderOptions options{.width = scene_.width, .height = scene_.height};
        options.settings = settings;
        renderers_.push_back(create_renderer(renderer, &scene_.device, options));
        renderers_.back()->set_world(world);
        renderers_.back()->set_lights(std::span(world.lights).first(lights));
        contenders_.push_back({.renderer = renderers_.back().get(), .stats = {}, .error = {}});
        return contenders_.size() - 1;
    }

    void run() {
        render_interleaved(contenders_, scene_.camera, {.frames = scene_.frames});
        for (const Contender& contender : contenders_)
            if (!contender.error.empty())
                throw Error(contender.error);
    }

    /// Device time; nobody knows a pass's own CPU time.
    Spread pass_ms(size_t index, std::string_view name) const {
        const auto& passes = contenders_[index].stats.passes;
        const auto pass = std::ranges::find(passes, name, &PassStats::name);
        if (pass == passes.end())
            throw Error(fmt::format("claims: pass {}: not there", name));
        return pass->gpu_ms;
    }

    double triangles_drawn(size_t index) const { return static_cast<double>(contenders_[index].stats.triangles_drawn); }

    Spread frame_ms(size_t index) const {
        const Stats& stats = contenders_[index].stats;
        return scene_.software ? stats.cpu_ms : stats.gpu_ms;
    }

    /// What one more light costs, between two renderers that differ in nothing else; absent when
    /// they have the same lights.
    std::optional<double> light_ms(size_t many, size_t few) const {
        const auto more = contenders_[many].stats.lights, fewer = contenders_[few].stats.lights;
        if (more <= fewer)
            return {};
        return (frame_ms(many).median - frame_ms(few).median) / static_cast<double>(more - fewer);
    }

private:
    const ClaimScene& scene_;
    std::vector<std::unique_ptr<Renderer>> renderers_;
    std::vector<Contender> contenders_;
};

/// Fills in what was measured of both sides.
Claim with(Claim claim, const Spread& a, const Spread& b) {
    claim.a = a.median;
    claim.b = b.median;
    claim.apart = a.min > b.max || b.min > a.max;
    return claim;
}

/// A share of each figure.
Spread each_of(const Spread& all, double count) { return {all.min / count, all.median / count, all.max / count}; }

/// Every second object of the world; its bounds and lights stay.
World half_of(const World& world) {
    World half = world;
    size_t index = 0;
    std::erase_if(half.instances, [&](const Instance&) { return index++ % 2 == 1; });
    return half;
}

/// The baseline scene with as many objects and lights as Kircher and Lawrance counted: 101 and 81.
std::unique_ptr<LoadedScene> counted_by_kircher() {
    constexpr size_t objects = 101, lights = 81;
    auto loaded = load_scene("lights", lights, 1, lights);
    World& world = loaded->world;
    world.instances.resize(std::min(world.instances.size(), objects));
    const std::vector<Instance> all = world.instances;
    constexpr double above = 2;
    for (size_t i = all.size(); i < objects; ++i) { // once more, above themselves
        Instance& more = world.instances.emplace_back(all[i % all.size()]);
        more.transform[3].y += above;
    }
    world.bounds_max.y += above;
    return loaded;
}

/// The world under eight directional lights that cast shadows, from all around.
World under_suns(const World& world) {
    World suns = world;
    suns.lights.clear();
    for (int i = 0; i < 8; ++i) {
        const double turn = 2.4 * i; // about the golden angle
        suns.lights.push_back({{.kind = LightKind::directional, .intensity = 0.4f},
                               glm::dvec3(0),
                               glm::normalize(glm::dvec3(std::cos(turn), -1.2, std::sin(turn)))});
    }
    return suns;
}

} // namespace

std::vector<Claim> time_claims(const ClaimScene& scene) {
    const World half = half_of(scene.world);
    const size_t all = scene.world.lights.size(), few = (all + 3) / 4;
    Timing t(scene);
    const size_t depth = t.add("z-prepass", scene.world, all);
    const size_t first = t.add("multipass", scene.world, all, {{"order", "objects"}});
    const size_t per_object = t.add("multipass", scene.world, all, {{"order", "objects"}, {"ambient", "per-object"}});
    const size_t ray = t.add("light-prepass", scene.world, all, {{"position", "ray"}});
    const size_t matrix = t.add("light-prepass", scene.world, all, {{"position", "matrix"}});
    const size_t multipass = t.add("multipass", scene.world, all);
    const size_t multipass_few = t.add("multipass", scene.world, few);
    const size_t prepass_few = t.add("light-prepass", scene.world, few);
    const size_t multipass_half = t.add("multipass", half, all);
    const size_t multipass_half_few = t.add("multipass", half, few);
    const size_t untrimmed = t.add("light-prepass", scene.world, all, {{"index-trimming", "off"}});
    const size_t trimmed =
        t.add("light-prepass", scene.world, all, {{"index-trimming", scene.software ? "host" : "device"}});
    const size_t conditional = t.add("light-prepass", scene.world, all, {{"occlusion", "queries"}});
    const World suns = under_suns(scene.world);
    const Settings shadows{{"shadows", "on"}};
    struct Suns {
        int count;
        size_t prepass, deferred;
    };
    std::vector<Suns> sunlit;
    for (const int count : {1, 2, 4, 8})
        sunlit.push_back({count, t.add("light-prepass", suns, size_t(count), shadows),
                          t.add("deferred", suns, size_t(count), shadows)});
    t.run();
    const auto counted = counted_by_kircher();
    const World& kircher = counted->world;
    const ClaimScene other{.device = scene.device,
                           .world = kircher,
                           .camera = kircher.cameras.at(0),
                           .width = scene.width,
                           .height = scene.height,
                           .frames = scene.frames,
                           .software = scene.software};
    Timing k(other);
    const size_t forward = k.add("multipass", kircher, kircher.lights.size());
    const size_t inferred = k.add("inferred", kircher, kircher.lights.size());
    k.run();

    const char* engel = "Engel, ShaderX7 8.5";
    const char* lee = "Lee, Prelighting";
    const std::string pass_time = fmt::format("device time of the pass, median of {}", scene.frames);
    const std::string frame_time =
        fmt::format("{} time of a frame, median of {}", scene.software ? "CPU" : "device", scene.frames);
    const std::string slope = fmt::format("one more light, between {} and {}; {}", few, all, frame_time);
    const char* depth_only = "rendering depth only can be done at two to eight times the speed compared to a "
                             "combined color and depth write";
    const auto light = t.light_ms(multipass, multipass_few);
    // One object cannot be halved.
    const bool halves = half.instances.size() < scene.world.instances.size();
    std::vector<Claim> claims{
        with({.id = "depth-against-ambient",
              .claim = depth_only,
              .source = engel,
              .how = "multipass, pass ambient : z-prepass, pass depth; " + pass_time,
              .from = 2,
              .to = 8},
             t.pass_ms(multipass, "ambient"), t.pass_ms(depth, "depth")),
        with({.id = "depth-against-normals",
              .claim = depth_only,
              .source = engel,
              .how = "light-prepass, pass depth-normal : z-prepass, pass depth; " + pass_time,
              .from = 2,
              .to = 8},
             t.pass_ms(ray, "depth-normal"), t.pass_ms(depth, "depth")),
        with({.id = "frustum-ray",
              .claim = "the frustum ray is a cheaper way to get the position than the matrix",
              .source = "Quandt, Light Pre-Pass Round 2",
              .how = "light-prepass, pass light, position=matrix : position=ray; " + pass_time,
              .from = clearly,
              .to = {}},
             t.pass_ms(matrix, "light"), t.pass_ms(ray, "light")),
        with({.id = "ambient-first",
              .claim = "ambient passes for all of the geometry before any point light pass: "
                       "sometimes better performance",
              .source = "XNA sample, Multipass Lighting",
              .how = "multipass, order=objects, ambient=per-object : ambient=first; " + frame_time,
              .from = clearly,
              .to = {}},
             t.frame_ms(per_object), t.frame_ms(first)),
        with({.id = "conditional-rendering",
              .claim = "conditional rendering: ~20% speed increase",
              .source = lee,
              .how = "light-prepass, occlusion=off : queries; " + frame_time,
              .from = 1.1,
              .to = 1.3},
             t.frame_ms(ray), t.frame_ms(conditional)),
        with({.id = "index-trimming",
              .claim = "trimmed index buffers: we could potentially save about ~30% on the depth pass",
              .source = lee,
              .how = "light-prepass, pass depth-normal, index-trimming=off : on; " + pass_time,
              .from = 1.3,
              .to = {}},
             t.pass_ms(untrimmed, "depth-normal"), t.pass_ms(trimmed, "depth-normal")),
        with({.id = "inferred-lighting",
              .claim = "101 objects, 81 lights: 29.4 ms, forward rendering 167 ms",
              .source = "Kircher, Lawrance, Inferred Lighting",
              .how = fmt::format("scene lights, {} objects, {} lights: multipass : inferred at 5/8; {}",
                                 kircher.instances.size(), kircher.lights.size(), frame_time),
              .from = 167 / 29.4,
              .to = {}},
             k.frame_ms(forward), k.frame_ms(inferred)),
        {.id = "vertices-culled",
         .claim = ">50% of vertices get culled after they already been transformed",
         .source = lee,
         .how = "light-prepass, triangles with index-trimming=off : on",
         .unit = "triangles",
         .a = t.triangles_drawn(untrimmed),
         .b = t.triangles_drawn(trimmed),
         .from = 2,
         .to = {}},
        {.id = "multipass-lights",
         .claim = "multi-pass is very slow: for each new light we are potentially re-rendering "
                  "the entire scene",
         .source = lee,
         .how = "multipass : light-prepass; " + slope,
         .unit = "ms a light",
         .a = light,
         .b = t.light_ms(ray, prepass_few),
         .from = clearly,
         .to = {}},
        {.id = "multipass-geometry",
         .claim = "multi-pass: for each light, render all meshes the light intersects",
         .source = lee,
         .how = fmt::format("multipass, {} objects : {} of them; {}", scene.world.instances.size(),
                            half.instances.size(), slope),
         .unit = "ms a light",
         .a = light,
         .b = halves ? t.light_ms(multipass_half, multipass_half_few) : std::nullopt,
         .from = clearly,
         .to = {}},
    };
    for (const Suns& some : sunlit) {
        const double count = some.count;
        claims.push_back(with(
            {.id = fmt::format("shadowed-directional-{}", some.count),
             .claim = "a directional light with shadows, reflections: 0.7 ms, deferred 3.3 ms",
             .source = engel,
             .how = fmt::format("{} directional lights with shadows, a light: deferred, pass light : light-prepass, "
                                "pass light; {}",
                                some.count, pass_time),
             .unit = "ms a light",
             .from = clearly,
             .to = {}},
            each_of(t.pass_ms(some.deferred, "light"), count), each_of(t.pass_ms(some.prepass, "light"), count)));
    }
    claims.push_back(with({.id = "more-directionals",
                           .claim = "by increasing the number of directional lights, the cost per light will go down",
                           .source = engel,
                           .how = "light-prepass, pass light, with shadows, a light: one light : eight; " + pass_time,
                           .unit = "ms a light",
                           .from = clearly,
                           .to = {}},
                          t.pass_ms(sunlit.front().prepass, "light"),
                          each_of(t.pass_ms(sunlit.back().prepass, "light"), 8)));
    return claims;
}

} // namespace prelight::app
