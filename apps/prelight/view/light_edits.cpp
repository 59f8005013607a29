#include "light_edits.hpp"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <limits>
#include <numbers>
#include <scene/procedural/random.hpp>

namespace prelight::app::viewer {

std::vector<LightEdits::Listed> LightEdits::applied(const std::vector<PlacedLight>& base) const {
    std::vector<Listed> out;
    out.reserve(numbers(base));
    for (uint32_t number = 0; number < numbers(base); ++number)
        if (auto light = one(base, number))
            out.push_back({number, *std::move(light)});
    return out;
}

std::optional<PlacedLight> LightEdits::one(const std::vector<PlacedLight>& base, uint32_t number) const {
    if (number >= numbers(base))
        return {};
    PlacedLight light = number < base.size() ? base[number] : added_[number - base.size()];
    if (const auto found = edits_.find(number); found != edits_.end()) {
        const Edit& edit = found->second;
        if (edit.removed)
            return {};
        light.position += edit.moved;
        if (edit.colour)
            light.light.colour = *edit.colour;
        if (edit.intensity)
            light.light.intensity = *edit.intensity;
        if (edit.range)
            light.light.range = *edit.range;
    }
    if (turned_ != 0) {
        const glm::dmat3 turn(glm::rotate(glm::dmat4(1), turned_, glm::dvec3(0, 1, 0)));
        light.position = centre_ + turn * (light.position - centre_);
        light.direction = turn * light.direction;
        light.up = turn * light.up;
    }
    return light;
}

uint32_t LightEdits::removed() const {
    return static_cast<uint32_t>(std::ranges::count_if(edits_, [](const auto& edit) { return edit.second.removed; }));
}

LightEdits::Edit* LightEdits::find(const std::vector<PlacedLight>& base, uint32_t number) {
    if (number >= numbers(base) || (edits_.contains(number) && edits_[number].removed))
        return nullptr;
    return &edits_[number];
}

bool LightEdits::move(const std::vector<PlacedLight>& base, uint32_t number, glm::dvec3 metres) {
    Edit* edit = find(base, number);
    if (!edit)
        return false;
    // What is seen has turned; what is kept has not.
    const glm::dmat3 back(glm::rotate(glm::dmat4(1), -turned_, glm::dvec3(0, 1, 0)));
    edit->moved += back * metres;
    return true;
}

bool LightEdits::colour(const std::vector<PlacedLight>& base, uint32_t number, glm::vec3 rgb) {
    Edit* edit = find(base, number);
    if (edit)
        edit->colour = glm::max(rgb, glm::vec3(0));
    return edit;
}

bool LightEdits::intensity(const std::vector<PlacedLight>& base, uint32_t number, float value) {
    Edit* edit = find(base, number);
    if (edit)
        edit->intensity = std::max(value, 0.0f);
    return edit;
}

bool LightEdits::range(const std::vector<PlacedLight>& base, uint32_t number, float metres) {
    Edit* edit = find(base, number);
    if (!edit)
        return false;
    const Light& light = number < base.size() ? base[number].light : added_[number - base.size()].light;
    // Falloffs of the source texts end at the range: they cannot do without.
    if (metres > 0)
        edit->range = metres;
    else if (light.falloff == Falloff::gltf)
        edit->range = std::numeric_limits<float>::infinity();
    return true;
}

bool LightEdits::remove(const std::vector<PlacedLight>& base, uint32_t number) {
    Edit* edit = find(base, number);
    if (edit)
        edit->removed = true;
    return edit;
}

uint32_t LightEdits::add(const std::vector<PlacedLight>& base, const PlacedLight& light) {
    added_.push_back(light);
    return static_cast<uint32_t>(base.size() + added_.size() - 1);
}

void LightEdits::randomise(const std::vector<PlacedLight>& base, uint64_t seed) {
    Random random(seed);
    for (uint32_t number = 0; number < numbers(base); ++number) {
        const glm::vec3 hue = hue_colour(random.unit(), 0.7f);
        const double factor = std::exp2(random.uniform(-1, 1));
        const Light& light = number < base.size() ? base[number].light : added_[number - base.size()].light;
        if (Edit* edit = find(base, number)) {
            edit->colour = hue;
            edit->intensity = static_cast<float>(light.intensity * factor);
        }
    }
}

void LightEdits::turn(double radians, glm::dvec3 centre) {
    turned_ = std::remainder(turned_ + radians, 2 * std::numbers::pi);
    centre_ = centre;
}

} // namespace prelight::app::viewer
