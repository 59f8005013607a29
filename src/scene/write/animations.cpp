#include <cmath>
#include <fmt/format.h>
#include <map>
#include <scene/animate.hpp>
#include <scene/write/parts.hpp>

namespace prelight::write {
namespace {

constexpr int float_component = 5126;

class AnimationWriter {
public:
    AnimationWriter(const Scene& scene, const std::vector<std::optional<uint32_t>>& meshes, Document& document)
        : scene_(scene), meshes_(meshes), document_(document) {}

    void write(size_t index) {
        const Animation& animation = scene_.animations[index];
        object_ = label("animation", index, animation.name);
        Json entry = Json::object();
        set_name(entry, animation.name);
        std::map<std::pair<uint32_t, size_t>, uint32_t> written; // sampler, values an element → index
        for (const AnimationChannel& channel : animation.channels) {
            if (channel.sampler >= animation.samplers.size() || channel.node >= scene_.nodes.size())
                document_.fail(object_, "a channel's sampler or node is not there");
            const Node& node = scene_.nodes[channel.node];
            const bool weights = channel.path == AnimationPath::weights;
            if (weights && !(node.mesh && meshes_.at(*node.mesh)))
                continue;
            const size_t width = weights ? 1 : channel.path == AnimationPath::rotation ? 4 : 3;
            const auto [at, is_new] = written.try_emplace({channel.sampler, width}, uint32_t(written.size()));
            if (is_new)
                entry["samplers"].push_back(sampler(animation.samplers[channel.sampler], width));
            entry["channels"].push_back(
                {{"sampler", at->second}, {"target", {{"node", channel.node}, {"path", name(channel.path)}}}});
        }
        if (entry.contains("channels")) // glTF knows no empty ones
            document_.add("animations", std::move(entry));
    }

private:
    static const char* name(AnimationPath path) {
        switch (path) {
        case AnimationPath::translation: return "translation";
        case AnimationPath::rotation: return "rotation";
        case AnimationPath::scale: return "scale";
        default: return "weights";
        }
    }

    Json sampler(const AnimationSampler& sampler, size_t width) {
        if (sampler.times.empty() || sampler.values.size() % width != 0)
            document_.fail(object_, "a sampler has no times, or values that do not fit");
        for (const std::vector<float>* list : {&sampler.times, &sampler.values})
            for (const float value : *list)
                if (!std::isfinite(value))
                    document_.fail(object_, "a sampler's numbers are not all finite");
        const uint32_t input =
            document_.add_accessor(view(sampler.times), float_component, "SCALAR", sampler.times.size());
        document_.root["accessors"][input]["min"] = Json::array({number(sampler.times.front())});
        document_.root["accessors"][input]["max"] = Json::array({number(sampler.times.back())});
        const char* type = width == 1 ? "SCALAR" : width == 3 ? "VEC3" : "VEC4";
        Json entry{{"input", input},
                   {"output", document_.add_accessor(view(sampler.values), float_component, type,
                                                     sampler.values.size() / width)}};
        if (sampler.interpolation != Interpolation::linear)
            entry["interpolation"] = sampler.interpolation == Interpolation::step ? "STEP" : "CUBICSPLINE";
        return entry;
    }

    uint32_t view(const std::vector<float>& values) {
        return document_.add_view(std::as_bytes(std::span(values)), ViewKind::other);
    }

    const Scene& scene_;
    const std::vector<std::optional<uint32_t>>& meshes_;
    Document& document_;
    std::string object_; ///< for messages
};

} // namespace

void add_skins(const Scene& scene, Document& document) {
    for (size_t i = 0; i < scene.skins.size(); ++i) {
        const Skin& skin = scene.skins[i];
        Json entry = Json::object();
        set_name(entry, skin.name);
        if (skin.joints.empty())
            document.fail(label("skin", i, skin.name), "has no joints");
        entry["joints"] = skin.joints;
        if (!skin.inverse_bind.empty()) { // the file knows single precision only
            std::vector<float> values;
            for (const glm::dmat4& matrix : skin.inverse_bind)
                for (int c = 0; c < 4; ++c)
                    for (int r = 0; r < 4; ++r)
                        values.push_back(static_cast<float>(matrix[c][r]));
            for (const float value : values)
                if (!std::isfinite(value))
                    document.fail(label("skin", i, skin.name), "its inverse bind matrices are not all finite");
            entry["inverseBindMatrices"] =
                document.add_accessor(document.add_view(std::as_bytes(std::span(values)), ViewKind::other),
                                      float_component, "MAT4", skin.inverse_bind.size());
        }
        document.add("skins", std::move(entry));
    }
}

void add_animations(const Scene& scene, const std::vector<std::optional<uint32_t>>& meshes, Document& document) {
    AnimationWriter writer(scene, meshes, document);
    for (size_t i = 0; i < scene.animations.size(); ++i)
        writer.write(i);
}

} // namespace prelight::write
