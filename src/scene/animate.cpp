#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
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
class Arc {
public:
    Arc(const Quaternion& a, const Quaternion& b) : a_(a), b_(b) {
        double cosine = 0;
        for (size_t i = 0; i < 4; ++i)
            cosine += a[i] * b[i];
        sign_ = cosine < 0 ? -1 : 1;
        angle_ = std::acos(std::min(std::abs(cosine), 1.0));
        sine_ = std::sin(angle_);
    }
    Quaternion at(double t) const {
        // Close quaternions: the sines' quotient is 0 / 0, and the straight line is as good.
        const double from = sine_ > 1e-6 ? std::sin((1 - t) * angle_) / sine_ : 1 - t;
        const double to = sine_ > 1e-6 ? std::sin(t * angle_) / sine_ : t;
        Quaternion q;
        for (size_t i = 0; i < 4; ++i)
            q[i] = from * a_[i] + sign_ * to * b_[i];
        return normalised(q, a_);
    }

private:
    Quaternion a_, b_;
    double sign_, angle_, sine_;
};

/// Lists of values that a keyframe has.
size_t parts_of(Interpolation interpolation) { return interpolation == Interpolation::cubic_spline ? 3 : 1; }

/// A sampler's keyframes as lists of `width` values.
class Keyframes {
public:
    Keyframes(const float* values, Interpolation interpolation, size_t width)
        : values_(values), width_(width), parts_(parts_of(interpolation)) {}

    Interpolation interpolation() const { return parts_ == 1 ? Interpolation::linear : Interpolation::cubic_spline; }

    double value(size_t keyframe, size_t i) const { return part(keyframe, parts_ / 2, i); }
    /// Of cubic splines.
    double in_tangent(size_t keyframe, size_t i) const { return part(keyframe, 0, i); }
    double out_tangent(size_t keyframe, size_t i) const { return part(keyframe, 2, i); }
    /// For what lies all over the memory: that keyframe and the next are about to be read.
    void ask_for(size_t keyframe) const {
        const float* const values = values_ + keyframe * parts_ * width_;
        __builtin_prefetch(values);
        __builtin_prefetch(values + 2 * parts_ * width_ - 1);
    }
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
KeyPlace place_in(const std::vector<float>& times, double time) {
    auto after = times.begin() + std::ptrdiff_t(next_guess(times, time));
    const bool right =
        (after == times.begin() || double(after[-1]) <= time) && (after == times.end() || time < double(*after));
    if (!right)
        after =
            std::upper_bound(times.begin(), times.end(), time, [](double at, float key) { return at < double(key); });
    if (after == times.begin())
        return {0, false};
    const size_t k = size_t(after - times.begin()) - 1;
    if (after == times.end())
        return {k, false};
    const double seconds = double(times[k + 1]) - double(times[k]);
    return {k, true, (time - double(times[k])) / seconds, seconds};
}

/// At two times between the same keyframes the arc is found once.
void sample_rotation(const Keyframes& keys, std::span<const KeyPlace> places, std::span<Quaternion> out) {
    std::optional<Arc> arc;
    for (size_t t = 0; t < places.size(); ++t) {
        const KeyPlace& at = places[t];
        const bool same = t > 0 && at.k == places[t - 1].k;
        const Quaternion a = keys.rotation(at.k);
        if (!at.between) {
            out[t] = a;
        } else if (keys.interpolation() == Interpolation::cubic_spline) {
            const Quaternion b = keys.rotation(at.k + 1);
            const Hermite hermite{keys, at.k, at.t, at.seconds};
            Quaternion result;
            for (size_t i = 0; i < 4; ++i)
                result[i] = hermite(a[i], b[i], i);
            out[t] = normalised(result, a);
        } else {
            if (!arc || !same)
                arc.emplace(a, keys.rotation(at.k + 1));
            out[t] = arc->at(at.t);
        }
    }
}

/// One value for each of `out`.
void sample_values(const Keyframes& keys, const KeyPlace& at, std::span<double> out) {
    const Hermite hermite{keys, at.k, at.t, at.seconds};
    for (size_t i = 0; i < out.size(); ++i) {
        const double a = keys.value(at.k, i);
        if (!at.between)
            out[i] = a;
        else if (keys.interpolation() == Interpolation::cubic_spline)
            out[i] = hermite(a, keys.value(at.k + 1, i), i);
        else
            out[i] = a + at.t * (keys.value(at.k + 1, i) - a);
    }
}

KeyPlace held(KeyPlace at, Interpolation interpolation) {
    at.between = at.between && interpolation != Interpolation::step;
    return at;
}

} // namespace

std::vector<double> sample(const AnimationSampler& sampler, double time, size_t width, bool rotation) {
    const Keyframes keys(sampler.values.data(), sampler.interpolation, width);
    const KeyPlace at = held(place_in(sampler.times, time), sampler.interpolation);
    if (rotation) {
        Quaternion q;
        sample_rotation(keys, std::span(&at, 1), std::span(&q, 1));
        return {q.begin(), q.end()};
    }
    std::vector<double> out(width);
    sample_values(keys, at, out);
    return out;
}

Channels::Channels(const Scene& scene, std::optional<uint32_t> animation) {
    if (animation && *animation >= scene.animations.size())
        throw Error(fmt::format("{}: animation {}: the file has {}", scene.name, *animation, scene.animations.size()));
    KnownTimes known;
    for (uint32_t i = 0; i < scene.animations.size(); ++i)
        if (!animation || *animation == i)
            add(scene, i, known);
}

bool Channels::ByContent::operator()(const std::vector<float>* a, const std::vector<float>* b) const {
    return a->size() != b->size() ? a->size() < b->size() : *a < *b;
}

void Channels::add(const Scene& scene, uint32_t index, KnownTimes& known) {
    const Animation& animation = scene.animations[index];
    for (size_t c = 0; c < animation.channels.size(); ++c) {
        const AnimationChannel& channel = animation.channels[c];
        const auto fail = [&](std::string_view reason) {
            throw Error(fmt::format("{}: animation {}: channel {}: {}", scene.name, index, c, reason));
        };
        if (channel.node >= scene.nodes.size() || channel.sampler >= animation.samplers.size())
            fail("its node or sampler is not there");
        const Node& node = scene.nodes[channel.node];
        const AnimationSampler& sampler = animation.samplers[channel.sampler];
        const uint32_t moved = node_at(scene, channel.node);
        if (std::exchange(nodes_[moved].taken[size_t(channel.path)], true))
            continue;
        const bool rotation = channel.path == AnimationPath::rotation;
        const bool weights = channel.path == AnimationPath::weights;
        if (weights && (!node.mesh || *node.mesh >= scene.meshes.size()))
            fail(fmt::format("node {} has no mesh with morph targets", channel.node));
        if (!weights && !node.trs)
            fail(fmt::format("node {} has no translation, rotation and scale", channel.node));
        const size_t width = weights ? morph_targets(scene.meshes[*node.mesh]) : rotation ? 4 : 3;
        const size_t parts = parts_of(sampler.interpolation);
        if (sampler.times.empty() || sampler.values.size() != sampler.times.size() * width * parts)
            fail(fmt::format("its sampler has {} values for {} keyframes of {}", sampler.values.size(),
                             sampler.times.size(), width * parts));
        if (weights)
            nodes_[moved].weights_sampler = &sampler;
        const auto [times, is_new] = known.try_emplace(&sampler.times, static_cast<uint32_t>(times_.size()));
        if (is_new)
            times_.push_back(&sampler.times);
        channels_.push_back({sampler.values.data(), moved, times->second, static_cast<uint32_t>(width), channel.path,
                             sampler.interpolation});
    }
}

uint32_t Channels::node_at(const Scene& scene, uint32_t node) {
    if (at_.empty())
        at_.resize(scene.nodes.size(), still);
    if (at_[node] == still) {
        at_[node] = static_cast<uint32_t>(nodes_.size());
        nodes_.push_back({.rest = scene.nodes[node].trs.value_or(Trs{})});
    }
    return at_[node];
}

Pose::Pose(const Scene& scene, const Channels& channels, std::span<const double> times)
    : scene_(scene), channels_(&channels), times_(times.size()) {
    for (const double time : times)
        if (!std::isfinite(time))
            throw Error(fmt::format("{}: the time {} is not finite", scene.name, time));
    std::vector<KeyPlace> places;
    places.reserve(channels.times_.size() * times_);
    for (const std::vector<float>* keyframes : channels.times_)
        for (const double time : times)
            places.push_back(place_in(*keyframes, time));
    trs_.reserve(channels.nodes_.size() * times_);
    for (const Channels::Moved& node : channels.nodes_)
        trs_.insert(trs_.end(), times_, node.rest);
    const auto keys_of = [](const Channels::Channel& channel) {
        return Keyframes(channel.values, channel.interpolation, channel.width);
    };
    constexpr size_t ahead = 12; // channels; their values have left the caches since the moment before
    for (size_t c = 0; c < channels.channels_.size(); ++c) {
        if (c + ahead < channels.channels_.size()) {
            const Channels::Channel& later = channels.channels_[c + ahead];
            keys_of(later).ask_for(places[later.times * times_].k);
        }
        const Channels::Channel& channel = channels.channels_[c];
        const Keyframes keys = keys_of(channel);
        std::array<KeyPlace, most_times> at;
        for (size_t t = 0; t < times_; ++t)
            at[t] = held(places[channel.times * times_ + t], channel.interpolation);
        Trs* const trs = &trs_[channel.moved * times_];
        if (channel.path == AnimationPath::rotation) {
            std::array<Quaternion, most_times> q;
            sample_rotation(keys, std::span(at).first(times_), q);
            for (size_t t = 0; t < times_; ++t)
                trs[t].rotation = glm::dquat(q[t][3], q[t][0], q[t][1], q[t][2]);
            continue;
        }
        if (channel.path == AnimationPath::weights)
            weights_.resize(channels.nodes_.size() * times_);
        for (size_t t = 0; t < times_; ++t) {
            if (channel.path == AnimationPath::weights) {
                std::vector<double>& weights = weights_[channel.moved * times_ + t];
                weights.resize(channel.width);
                sample_values(keys, at[t], weights);
            } else {
                std::array<double, 3> v;
                sample_values(keys, at[t], v);
                (channel.path == AnimationPath::scale ? trs[t].scale : trs[t].translation) = {v[0], v[1], v[2]};
            }
        }
    }
}

glm::dmat4 Pose::local(uint32_t node, size_t time) const {
    const uint32_t moved = find(node);
    return moved != Channels::still && channels_->nodes_[moved].placed() ? trs_[moved * times_ + time].matrix()
                                                                         : scene_.nodes[node].local;
}

const AnimationSampler* Pose::weights_sampler(uint32_t node) const {
    const uint32_t moved = find(node);
    return moved == Channels::still ? nullptr : channels_->nodes_[moved].weights_sampler;
}

std::vector<double> Pose::weights(uint32_t index, size_t time) const {
    const Node& node = scene_.nodes[index];
    const size_t count = node.mesh ? morph_targets(scene_.meshes[*node.mesh]) : 0;
    if (weights_sampler(index))
        return weights_[find(index) * times_ + time];
    std::vector<double> weights(count);
    const auto& given = !node.weights.empty() || count == 0 ? node.weights : scene_.meshes[*node.mesh].weights;
    for (size_t i = 0; i < std::min(count, given.size()); ++i)
        weights[i] = double(given[i]);
    return weights;
}

} // namespace prelight
