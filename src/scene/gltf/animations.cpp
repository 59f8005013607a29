#include <cmath>
#include <fmt/format.h>
#include <map>
#include <scene/animate.hpp>
#include <scene/gltf/animations.hpp>

namespace prelight::gltf {
namespace {

class AnimationReader {
public:
    AnimationReader(Document& document, Accessors& accessors, const Scene& scene, const Item& item)
        : document_(document), accessors_(accessors), scene_(scene), item_(item),
          samplers_(item.items("samplers", "sampler")) {
        animation_.name = item.text("name");
    }

    Animation read() {
        for (const Item& channel : item_.items("channels", "channel"))
            read_channel(channel);
        return std::move(animation_);
    }

private:
    /// A sampler once read, and how many values its accessor has in an element.
    struct Read {
        uint32_t index, width;
    };

    void read_channel(const Item& channel) {
        document_.charge(channel.label(), 1, sizeof(AnimationChannel));
        const uint32_t sampler_index = channel.required_index("sampler", samplers_.size());
        const auto target = channel.object("target");
        if (!target)
            channel.fail("target is missing");
        const auto node = target->index("node", scene_.nodes.size());
        const auto path = path_of(target->text("path"));
        if (!node || !path)
            return document_.warn("channels that move no node's translation, rotation, scale or weights "
                                  "are not evaluated",
                                  channel.label());
        const bool weights = *path == AnimationPath::weights;
        if (!weights && !scene_.nodes[*node].trs)
            channel.fail(fmt::format("node {} has a matrix, which no animation can move", *node));
        const size_t targets =
            scene_.nodes[*node].mesh ? morph_targets(scene_.meshes[*scene_.nodes[*node].mesh]) : 0;
        if (weights && targets == 0)
            return document_.warn("channels of weights without morph targets are not evaluated",
                                  channel.label());
        const Read sampler = read_sampler(sampler_index);
        check_fit(channel, animation_.samplers[sampler.index], sampler.width,
                  weights ? 1 : *path == AnimationPath::rotation ? 4 : 3, weights ? targets : 1);
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
    static void check_fit(const Item& channel, const AnimationSampler& sampler, uint32_t has_width,
                          uint32_t width, size_t elements) {
        if (has_width != width)
            channel.fail(fmt::format("its sampler's values have {} components instead of {}", has_width,
                                     width));
        const size_t parts = sampler.interpolation == Interpolation::cubic_spline ? 3 : 1;
        const size_t wanted = sampler.times.size() * elements * parts;
        if (sampler.values.size() / width != wanted)
            channel.fail(fmt::format("its sampler has {} values for {} keyframes, which need {}",
                                     sampler.values.size() / width, sampler.times.size(), wanted));
    }

    Read read_sampler(uint32_t index) {
        if (const auto found = read_.find(index); found != read_.end())
            return found->second;
        const Item& item = samplers_[index];
        AnimationSampler sampler;
        sampler.interpolation = interpolation_of(item);
        read_times(item, sampler);
        const Read read{uint32_t(animation_.samplers.size()), read_values(item, sampler)};
        animation_.samplers.push_back(std::move(sampler));
        return read_[index] = read;
    }

    static Interpolation interpolation_of(const Item& item) {
        const std::string name = item.text("interpolation");
        if (name.empty() || name == "LINEAR")
            return Interpolation::linear;
        if (name == "STEP")
            return Interpolation::step;
        if (name == "CUBICSPLINE")
            return Interpolation::cubic_spline;
        item.fail(fmt::format("interpolation \"{}\" is not known", printable(name)));
    }

    const Elements& accessor(const Item& item, const char* key) {
        return accessors_.get(item.required_index(key, document_.count(Table::accessors)));
    }

    void read_times(const Item& item, AnimationSampler& sampler) {
        const Elements& source = accessor(item, "input");
        if (source.width != 1 || source.component != Component::f32)
            item.fail("input: its type is not fit for that");
        document_.charge(item.label(), source.count, sizeof(float));
        sampler.times.reserve(source.count);
        for (uint32_t i = 0; i < source.count; ++i) {
            const float time = source.vec(i).x;
            if (!std::isfinite(time) || time < 0)
                item.fail(fmt::format("input: time {} is negative or not finite", i));
            if (i > 0 && time <= sampler.times.back())
                item.fail(fmt::format("input: time {} is not after the one before", i));
            sampler.times.push_back(time);
        }
    }

    uint32_t read_values(const Item& item, AnimationSampler& sampler) {
        const Elements& source = accessor(item, "output");
        if (source.component != Component::f32 &&
            (!source.normalized || source.component == Component::u32))
            item.fail("output: its type is not fit for that");
        document_.charge(item.label(), source.count, source.width * sizeof(float));
        sampler.values.reserve(size_t(source.count) * source.width);
        for (uint32_t i = 0; i < source.count; ++i) {
            const glm::vec4 value = source.vec(i);
            for (uint32_t c = 0; c < source.width; ++c) {
                if (!std::isfinite(value[int(c)]))
                    item.fail(fmt::format("output: value {} is not finite", i));
                sampler.values.push_back(value[int(c)]);
            }
        }
        return source.width;
    }

    Document& document_;
    Accessors& accessors_;
    const Scene& scene_;
    const Item& item_;
    std::vector<Item> samplers_;
    std::map<uint32_t, Read> read_; ///< by the file's index
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
