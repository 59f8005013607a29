#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <scene/animate.hpp>
#include <utility>

namespace prelight {
namespace {

using Values = std::vector<double>;

double length(const Values& q) {
    double sum = 0;
    for (const double v : q)
        sum += v * v;
    return std::sqrt(sum);
}

/// Unit length; `fallback` where there is no direction.
Values normalised(Values q, const Values& fallback) {
    const double l = length(q);
    if (!(l > 1e-12) || !std::isfinite(l))
        return fallback;
    for (double& v : q)
        v /= l;
    return q;
}

const Values identity{0, 0, 0, 1};

/// Appendix C.4: along the shorter of the two great arcs.
Values slerp(const Values& a, Values b, double t) {
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
    return normalised(std::move(b), a);
}

/// A sampler's keyframes as lists of `width` values.
struct Keyframes {
    const AnimationSampler& sampler;
    size_t width;
    bool rotation;

    /// `part`: 0 in-tangent, 1 value, 2 out-tangent with cubic splines; else 0.
    Values part(size_t keyframe, size_t part) const {
        const bool cubic = sampler.interpolation == Interpolation::cubic_spline;
        const size_t first = (keyframe * (cubic ? 3 : 1) + part) * width;
        const auto at = sampler.values.begin() + std::ptrdiff_t(first);
        return {at, at + std::ptrdiff_t(width)};
    }
    Values value(size_t keyframe) const {
        const bool cubic = sampler.interpolation == Interpolation::cubic_spline;
        Values v = part(keyframe, cubic ? 1 : 0);
        return rotation ? normalised(std::move(v), identity) : v;
    }
};

/// Appendix C.5; tangents are per second, so they are scaled with the keyframes' distance.
Values hermite(const Keyframes& keys, size_t k, double t, double seconds) {
    const double t2 = t * t, t3 = t2 * t;
    const Values a = keys.value(k), out = keys.part(k, 2);
    const Values b = keys.value(k + 1), in = keys.part(k + 1, 0);
    Values result(keys.width);
    for (size_t i = 0; i < keys.width; ++i)
        result[i] = (2 * t3 - 3 * t2 + 1) * a[i] + seconds * (t3 - 2 * t2 + t) * out[i] + (-2 * t3 + 3 * t2) * b[i] +
                    seconds * (t3 - t2) * in[i];
    return keys.rotation ? normalised(std::move(result), a) : result;
}

} // namespace

std::vector<double> sample(const AnimationSampler& sampler, double time, size_t width, bool rotation) {
    const std::vector<float>& times = sampler.times;
    const Keyframes keys{sampler, width, rotation};
    const auto after =
        std::upper_bound(times.begin(), times.end(), time, [](double t, float key) { return t < double(key); });
    if (after == times.begin())
        return keys.value(0);
    const size_t k = size_t(after - times.begin()) - 1;
    if (after == times.end() || sampler.interpolation == Interpolation::step)
        return keys.value(k);
    const double seconds = double(times[k + 1]) - double(times[k]);
    const double t = (time - double(times[k])) / seconds;
    if (sampler.interpolation == Interpolation::cubic_spline)
        return hermite(keys, k, t, seconds);
    const Values a = keys.value(k), b = keys.value(k + 1);
    if (rotation)
        return slerp(a, b, t);
    Values result(width);
    for (size_t i = 0; i < width; ++i)
        result[i] = a[i] + t * (b[i] - a[i]);
    return result;
}

Pose::Pose(const Scene& scene, double time, std::optional<uint32_t> animation) : scene_(scene) {
    if (!std::isfinite(time))
        throw Error(fmt::format("{}: the time {} is not finite", scene.name, time));
    if (animation && *animation >= scene.animations.size())
        throw Error(fmt::format("{}: animation {}: the file has {}", scene.name, *animation, scene.animations.size()));
    for (uint32_t i = 0; i < scene.animations.size(); ++i)
        if (!animation || *animation == i)
            apply(i, time);
}

void Pose::apply(uint32_t index, double time) {
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
        bool& taken = taken_[channel.node][size_t(channel.path)];
        if (std::exchange(taken, true))
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
        const Values values = sample(sampler, time, width, rotation);
        if (weights) {
            weights_[channel.node] = values;
            continue;
        }
        Trs& trs = placed_.try_emplace(channel.node, *node.trs).first->second;
        if (rotation)
            trs.rotation = glm::dquat(values[3], values[0], values[1], values[2]);
        else
            (channel.path == AnimationPath::scale ? trs.scale : trs.translation) = {values[0], values[1], values[2]};
    }
}

glm::dmat4 Pose::local(uint32_t node) const {
    const auto found = placed_.find(node);
    return found == placed_.end() ? scene_.nodes[node].local : found->second.matrix();
}

std::vector<double> Pose::weights(uint32_t index) const {
    const Node& node = scene_.nodes[index];
    const size_t count = node.mesh ? morph_targets(scene_.meshes[*node.mesh]) : 0;
    if (const auto found = weights_.find(index); found != weights_.end())
        return found->second;
    std::vector<double> weights(count);
    const auto& given = !node.weights.empty() || count == 0 ? node.weights : scene_.meshes[*node.mesh].weights;
    for (size_t i = 0; i < std::min(count, given.size()); ++i)
        weights[i] = double(given[i]);
    return weights;
}

} // namespace prelight
