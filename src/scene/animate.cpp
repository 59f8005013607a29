#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <scene/animate.hpp>
#include <span>
#include <utility>

namespace prelight {
namespace {

/// x, y, z, w.
using Quaternion = std::array<double, 4>;

/// Unit length; `fallback` where there is no direction.
Quaternion normalised(Quaternion q, const Quaternion& fallback) {
    double sum = 0;
    for (const double v : q)
        sum += v * v;
    const double l = std::sqrt(sum);
    if (!(l > 1e-12) || !std::isfinite(l))
        return fallback;
    for (double& v : q)
        v /= l;
    return q;
}

/// Appendix C.4: along the shorter of the two great arcs.
Quaternion slerp(const Quaternion& a, Quaternion b, double t) {
    double cosine = 0;
    for (size_t i = 0; i < 4; ++i)
        cosine += a[i] * b[i];
    const double sign = cosine < 0 ? -1 : 1;
    cosine = std::min(std::abs(cosine), 1.0);
    // Close quaternions: the sines' quotient is 0 / 0, and the straight line is as good.
    const double angle = std::acos(cosine), sine = std::sin(angle);
    const double from = sine > 1e-6 ? std::sin((1 - t) * angle) / sine : 1 - t;
    const double to = sine > 1e-6 ? std::sin(t * angle) / sine : t;
    for (size_t i = 0; i < 4; ++i)
        b[i] = from * a[i] + sign * to * b[i];
    return normalised(b, a);
}

/// A sampler's keyframes as lists of `width` values.
class Keyframes {
public:
    Keyframes(const AnimationSampler& sampler, size_t width)
        : values_(sampler.values.data()), width_(width),
          parts_(sampler.interpolation == Interpolation::cubic_spline ? 3 : 1) {}

    double value(size_t keyframe, size_t i) const { return part(keyframe, parts_ / 2, i); }
    /// Of cubic splines.
    double in_tangent(size_t keyframe, size_t i) const { return part(keyframe, 0, i); }
    double out_tangent(size_t keyframe, size_t i) const { return part(keyframe, 2, i); }
    Quaternion rotation(size_t keyframe) const {
        return normalised({value(keyframe, 0), value(keyframe, 1), value(keyframe, 2), value(keyframe, 3)},
                          {0, 0, 0, 1});
    }

private:
    double part(size_t keyframe, size_t part, size_t i) const {
        return double(values_[(keyframe * parts_ + part) * width_ + i]);
    }
    const float* values_;
    size_t width_, parts_;
};

/// Appendix C.5; tangents are per second, so they are scaled with the keyframes' distance.
struct Hermite {
    const Keyframes& keys;
    size_t k; ///< from this keyframe to the next
    double t, seconds;
    /// Between a and b, number `i` of the two keyframes' values.
    double operator()(double a, double b, size_t i) const {
        const double t2 = t * t, t3 = t2 * t;
        return (2 * t3 - 3 * t2 + 1) * a + seconds * (t3 - 2 * t2 + t) * keys.out_tangent(k, i) +
               (-2 * t3 + 3 * t2) * b + seconds * (t3 - t2) * keys.in_tangent(k + 1, i);
    }
};

/// Where a time lies among the keyframes.
struct KeyPlace {
    size_t k;
    bool between; ///< this keyframe and the next; else there is nothing to interpolate
    double t = 0, seconds = 0;
};
/// The first keyframe after a time, were they all as far from one another, as most files have them: a look there costs
/// less memory than a search.
size_t next_guess(const std::vector<float>& times, double time) {
    const double first = double(times.front()), last = double(times.back());
    if (!(time >= first))
        return 0;
    if (!(time < last))
        return times.size();
    return 1 + size_t((time - first) / (last - first) * double(times.size() - 1));
}
KeyPlace place_in(const AnimationSampler& sampler, double time) {
    const std::vector<float>& times = sampler.times;
    auto after = times.begin() + std::ptrdiff_t(next_guess(times, time));
    const bool right =
        (after == times.begin() || double(after[-1]) <= time) && (after == times.end() || time < double(*after));
    if (!right)
        after =
            std::upper_bound(times.begin(), times.end(), time, [](double at, float key) { return at < double(key); });
    if (after == times.begin())
        return {0, false};
    const size_t k = size_t(after - times.begin()) - 1;
    if (after == times.end() || sampler.interpolation == Interpolation::step)
        return {k, false};
    const double seconds = double(times[k + 1]) - double(times[k]);
    return {k, true, (time - double(times[k])) / seconds, seconds};
}

Quaternion sample_rotation(const AnimationSampler& sampler, double time) {
    const Keyframes keys(sampler, 4);
    const KeyPlace at = place_in(sampler, time);
    const Quaternion a = keys.rotation(at.k);
    if (!at.between)
        return a;
    const Quaternion b = keys.rotation(at.k + 1);
    if (sampler.interpolation != Interpolation::cubic_spline)
        return slerp(a, b, at.t);
    const Hermite hermite{keys, at.k, at.t, at.seconds};
    Quaternion result;
    for (size_t i = 0; i < 4; ++i)
        result[i] = hermite(a[i], b[i], i);
    return normalised(result, a);
}

/// One value for each of `out`.
void sample_values(const AnimationSampler& sampler, double time, std::span<double> out) {
    const Keyframes keys(sampler, out.size());
    const KeyPlace at = place_in(sampler, time);
    const Hermite hermite{keys, at.k, at.t, at.seconds};
    for (size_t i = 0; i < out.size(); ++i) {
        const double a = keys.value(at.k, i);
        if (!at.between)
            out[i] = a;
        else if (sampler.interpolation == Interpolation::cubic_spline)
            out[i] = hermite(a, keys.value(at.k + 1, i), i);
        else
            out[i] = a + at.t * (keys.value(at.k + 1, i) - a);
    }
}

} // namespace

std::vector<double> sample(const AnimationSampler& sampler, double time, size_t width, bool rotation) {
    std::vector<double> out(width);
    if (rotation) {
        const Quaternion q = sample_rotation(sampler, time);
        return {q.begin(), q.end()};
    }
    sample_values(sampler, time, out);
    return out;
}

Pose::Pose(const Scene& scene, std::span<const double> times, std::optional<uint32_t> animation)
    : scene_(scene), times_(times.size()) {
    for (const double time : times)
        if (!std::isfinite(time))
            throw Error(fmt::format("{}: the time {} is not finite", scene.name, time));
    if (animation && *animation >= scene.animations.size())
        throw Error(fmt::format("{}: animation {}: the file has {}", scene.name, *animation, scene.animations.size()));
    size_t channels = 0;
    for (const Animation& each : scene.animations)
        channels += each.channels.size();
    moved_.reserve(std::min(channels, scene.nodes.size()));
    for (uint32_t i = 0; i < scene.animations.size(); ++i)
        if (!animation || *animation == i)
            apply(i, times);
}

void Pose::apply(uint32_t index, std::span<const double> times) {
    const Animation& animation = scene_.animations[index];
    for (size_t c = 0; c < animation.channels.size(); ++c) {
        const AnimationChannel& channel = animation.channels[c];
        const auto fail = [&](std::string_view reason) {
            throw Error(fmt::format("{}: animation {}: channel {}: {}", scene_.name, index, c, reason));
        };
        if (channel.node >= scene_.nodes.size() || channel.sampler >= animation.samplers.size())
            fail("its node or sampler is not there");
        const Node& node = scene_.nodes[channel.node];
        const AnimationSampler& sampler = animation.samplers[channel.sampler];
        Moved& moved = moved_at(channel.node);
        if (std::exchange(moved.taken[size_t(channel.path)], true))
            continue;
        const bool rotation = channel.path == AnimationPath::rotation;
        const bool weights = channel.path == AnimationPath::weights;
        if (weights && (!node.mesh || *node.mesh >= scene_.meshes.size()))
            fail(fmt::format("node {} has no mesh with morph targets", channel.node));
        if (!weights && !node.trs)
            fail(fmt::format("node {} has no translation, rotation and scale", channel.node));
        const size_t width = weights ? morph_targets(scene_.meshes[*node.mesh]) : rotation ? 4 : 3;
        const size_t parts = sampler.interpolation == Interpolation::cubic_spline ? 3 : 1;
        if (sampler.times.empty() || sampler.values.size() != sampler.times.size() * width * parts)
            fail(fmt::format("its sampler has {} values for {} keyframes of {}", sampler.values.size(),
                             sampler.times.size(), width * parts));
        if (weights)
            moved.weights_sampler = &sampler;
        for (size_t t = 0; t < times.size(); ++t) {
            Trs& trs = moved.trs[t];
            if (weights) {
                moved.weights[t].resize(width);
                sample_values(sampler, times[t], moved.weights[t]);
            } else if (rotation) {
                const Quaternion q = sample_rotation(sampler, times[t]);
                trs.rotation = glm::dquat(q[3], q[0], q[1], q[2]);
            } else {
                std::array<double, 3> v;
                sample_values(sampler, times[t], v);
                (channel.path == AnimationPath::scale ? trs.scale : trs.translation) = {v[0], v[1], v[2]};
            }
        }
    }
}

Pose::Moved& Pose::moved_at(uint32_t node) {
    if (at_.empty())
        at_.resize(scene_.nodes.size(), still);
    if (at_[node] == still) {
        at_[node] = static_cast<uint32_t>(moved_.size());
        moved_.emplace_back().trs.fill(scene_.nodes[node].trs.value_or(Trs{}));
    }
    return moved_[at_[node]];
}

const Pose::Moved* Pose::find(uint32_t node) const {
    return at_.empty() || at_[node] == still ? nullptr : &moved_[at_[node]];
}

glm::dmat4 Pose::local(uint32_t node, size_t time) const {
    const Moved* const moved = find(node);
    return moved && moved->is_placed() ? moved->trs[time].matrix() : scene_.nodes[node].local;
}

const AnimationSampler* Pose::weights_sampler(uint32_t node) const {
    const Moved* const moved = find(node);
    return moved ? moved->weights_sampler : nullptr;
}

std::vector<double> Pose::weights(uint32_t index, size_t time) const {
    const Node& node = scene_.nodes[index];
    const size_t count = node.mesh ? morph_targets(scene_.meshes[*node.mesh]) : 0;
    if (const Moved* const moved = find(index); moved && moved->weights_sampler)
        return moved->weights[time];
    std::vector<double> weights(count);
    const auto& given = !node.weights.empty() || count == 0 ? node.weights : scene_.meshes[*node.mesh].weights;
    for (size_t i = 0; i < std::min(count, given.size()); ++i)
        weights[i] = double(given[i]);
    return weights;
}

} // namespace prelight
