#include <cmath>
#include <fmt/format.h>
#include <map>
#include <scene/animate.hpp>
#include <scene/gltf/animations.hpp>
#include <scene/gltf/keyframes.hpp>
#include <scene/gltf/kinds.hpp>

namespace prelight::gltf {
namespace {

/// Why a channel cannot be evaluated.
struct Unusable : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class AnimationReader {
public:
    AnimationReader(Document& document, Accessors& accessors, const Scene& scene, const Item& item)
        : document_(document), accessors_(accessors), scene_(scene), item_(item),
          samplers_(item.items("samplers", "sampler")) {
        animation_.name = item.text("name");
    }

    Animation read() {
        for (const Item& channel : item_.items("channels", "channel")) {
            try {
                read_channel(channel);
            } catch (const Unusable& reason) {
                channel.warn("{}; the channel is left out", reason.what());
            }
        }
        return std::move(animation_);
    }

private:
    /// A sampler once read.
    struct Read {
        uint32_t index = 0;
        uint32_t width = 0;      ///< values in an element
        size_t per_keyframe = 0; ///< elements, as the file has them
        std::string unusable;    ///< why; empty: it is usable
    };

    void read_channel(const Item& channel) {
        document_.charge(channel.label(), 1, sizeof(AnimationChannel));
        const uint32_t sampler_index = channel.required_index("sampler", samplers_.size());
        const auto target = channel.object("target");
        if (!target)
            throw Unusable("target is missing");
        const auto node = target->index("node", scene_.nodes.size());
        const auto path = path_of(target->text("path"));
        if (!node || !path)
            return document_.warn("channels that move no node's translation, rotation, scale or weights "
                                  "are not evaluated",
                                  channel.label());
        const bool weights = *path == AnimationPath::weights;
        if (!weights && !scene_.nodes[*node].trs)
            throw Unusable(fmt::format("node {} has a matrix, which no animation can move", *node));
        const size_t targets = scene_.nodes[*node].mesh ? morph_targets(scene_.meshes[*scene_.nodes[*node].mesh]) : 0;
        if (weights && targets == 0)
            return document_.warn("channels of weights without morph targets are not evaluated", channel.label());
        const Read& sampler = read_sampler(sampler_index, *path);
        check_fit(sampler, weights ? 1 : *path == AnimationPath::rotation ? 4 : 3, weights ? targets : 1);
        if (*path == AnimationPath::rotation)
            check_quaternions(samplers_[sampler_index], animation_.samplers[sampler.index]);
        animation_.channels.push_back({sampler.index, *node, *path});
    }

    static std::optional<AnimationPath> path_of(const std::string& path) {
        if (path == "translation")
            return AnimationPath::translation;
        if (path == "rotation")
            return AnimationPath::rotation;
        if (path == "scale")
            return AnimationPath::scale;
        if (path == "weights")
            return AnimationPath::weights;
        return {};
    }

    /// `elements` of `width` values a keyframe, three times that with tangents.
    void check_fit(const Read& sampler, uint32_t width, size_t elements) const {
        if (sampler.width != width)
            throw Unusable(fmt::format("its sampler's values have {} components instead of {}", sampler.width, width));
        const bool cubic = animation_.samplers[sampler.index].interpolation == Interpolation::cubic_spline;
        if (const size_t wanted = elements * (cubic ? 3 : 1); sampler.per_keyframe != wanted)
            throw Unusable(fmt::format("its sampler has {} values for each keyframe, which needs {}",
                                       sampler.per_keyframe, wanted));
    }

    /// They are made unit ones where they are used; here it is told.
    static void check_quaternions(const Item& item, const AnimationSampler& sampler) {
        const bool cubic = sampler.interpolation == Interpolation::cubic_spline;
        uint64_t bad = 0;
        size_t first = 0;
        for (size_t key = 0; key < sampler.times.size(); ++key) {
            const float* q = &sampler.values[key * (cubic ? 12 : 4) + (cubic ? 4 : 0)];
            if (!is_unit(std::hypot(std::hypot(double(q[0]), double(q[1])), std::hypot(double(q[2]), double(q[3])))) &&
                bad++ == 0)
                first = key;
        }
        if (bad > 0)
            item.warnings().add(
                "no unit quaternions", item.label(),
                fmt::format("output: the quaternion of keyframe {} is no unit one; it is made one", first), bad);
    }

    const Read& read_sampler(uint32_t index, AnimationPath path) {
        const auto [found, is_new] = read_.try_emplace({index, path});
        Read& read = found->second;
        if (is_new) {
            try {
                AnimationSampler sampler = make_sampler(samplers_[index], path, read);
                read.index = uint32_t(animation_.samplers.size());
                animation_.samplers.push_back(std::move(sampler));
            } catch (const Unusable& reason) {
                read.unusable = reason.what();
            }
        }
        if (!read.unusable.empty())
            throw Unusable(fmt::format("sampler {}: {}", index, read.unusable));
        return read;
    }

    AnimationSampler make_sampler(const Item& item, AnimationPath path, Read& read) {
        AnimationSampler sampler;
        sampler.interpolation = interpolation_of(item);
        read_times(item, sampler);
        const size_t elements = read_values(item, path, sampler, read.width);
        if (elements % sampler.times.size() != 0)
            throw Unusable(fmt::format("it has {} values for {} keyframes", elements, sampler.times.size()));
        read.per_keyframe = elements / sampler.times.size();
        repair_keyframes(item, sampler, read.per_keyframe * read.width);
        if (sampler.times.empty())
            throw Unusable("no keyframe of it is finite");
        return sampler;
    }

    static Interpolation interpolation_of(const Item& item) {
        const std::string name = item.text("interpolation");
        if (name == "STEP")
            return Interpolation::step;
        if (name == "CUBICSPLINE")
            return Interpolation::cubic_spline;
        if (!name.empty() && name != "LINEAR")
            item.warn("interpolation \"{}\" is not known; LINEAR is used", printable(name));
        return Interpolation::linear;
    }

    const Elements& accessor(const Item& item, const char* key) {
        return accessors_.get(item.required_index(key, document_.count(Table::accessors)));
    }

    void read_times(const Item& item, AnimationSampler& sampler) {
        const Elements& source = accessor(item, "input");
        if (source.width != 1 || source.component != Component::f32)
            throw Unusable("input: " + kind_mismatch(source, "SCALAR of floats"));
        document_.charge(item.label(), source.count, sizeof(float));
        sampler.times.reserve(source.count);
        for (uint32_t i = 0; i < source.count; ++i)
            sampler.times.push_back(source.vec(i).x);
    }

    /// Number of elements.
    size_t read_values(const Item& item, AnimationPath path, AnimationSampler& sampler, uint32_t& width) {
        const Elements& source = accessor(item, "output");
        const Fit fit = fit_animation(source, path);
        if (!fit.usable)
            throw Unusable("output: " + fit.warning);
        if (!fit.warning.empty())
            item.warn("output: {}", fit.warning);
        document_.charge(item.label(), source.count, source.width * sizeof(float));
        sampler.values.reserve(size_t(source.count) * source.width);
        for (uint32_t i = 0; i < source.count; ++i) {
            const glm::vec4 value = source.vec(i) / fit.divisor;
            for (uint32_t c = 0; c < source.width; ++c)
                sampler.values.push_back(value[int(c)]);
        }
        width = source.width;
        return source.count;
    }

    Document& document_;
    Accessors& accessors_;
    const Scene& scene_;
    const Item& item_;
    std::vector<Item> samplers_;
    std::map<std::pair<uint32_t, AnimationPath>, Read> read_; ///< by the file's index and what it is read for
    Animation animation_;
};

} // namespace

void read_animations(Document& document, Accessors& accessors, Scene& scene) {
    const size_t count = document.count(Table::animations);
    document.charge("animations", count, sizeof(Animation));
    for (size_t i = 0; i < count; ++i) {
        const Item item = document.item(Table::animations, i);
        scene.animations.push_back(AnimationReader(document, accessors, scene, item).read());
    }
}

} // namespace prelight::gltf
