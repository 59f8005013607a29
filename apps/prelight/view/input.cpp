#include "input.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace prelight::app::viewer {
namespace {

constexpr double drag_begins = 3;               // pixels
constexpr double orbit_turn = std::numbers::pi; // radians for a drag as long as the picture is high
constexpr double look_turn = std::numbers::pi / 2;
constexpr double key_turn = std::numbers::pi / 3; // radians a second
constexpr double fast = 4;

} // namespace

void Input::resize(uint32_t width, uint32_t height) {
    if (width == 0 || height == 0)
        return;
    width_ = width;
    height_ = height;
}

PicturePoint Input::point(double x, double y) const { return {2 * x / width_ - 1, 1 - 2 * y / height_, aspect()}; }

void Input::key(const std::string& name, bool down) {
    if (down)
        down_.insert(name);
    else
        down_.erase(name);
}

bool Input::button(const std::string& name, bool down, double x, double y) {
    mouse_ = {x, y};
    if (down) {
        if (dragging_.empty()) {
            dragging_ = name;
            pressed_ = mouse_;
            moved_ = false;
        }
        return false;
    }
    if (dragging_ != name)
        return false;
    dragging_.clear();
    return name == "left" && !moved_ && !is_down("Shift");
}

std::optional<Rig> Input::move(const Rig& rig, double x, double y) {
    const glm::dvec2 by = glm::dvec2(x, y) - mouse_;
    mouse_ = {x, y};
    if (dragging_.empty() || (!moved_ && glm::length(mouse_ - pressed_) < drag_begins))
        return {};
    moved_ = true;
    const glm::dvec2 share = by / height_;
    if (dragging_ == "right")
        return looked(rig, -share.x * look_turn, -share.y * look_turn);
    if (dragging_ == "middle" || is_down("Shift"))
        return panned(rig, -share.x, share.y);
    return orbited(rig, -share.x * orbit_turn, -share.y * orbit_turn);
}

void Input::release_all() {
    down_.clear();
    dragging_.clear();
}

std::optional<Rig> Input::step(const Rig& rig, double pace) const {
    const auto axis = [&](const char* plus, const char* minus) { return double(is_down(plus)) - is_down(minus); };
    const glm::dvec3 go(axis("D", "A"), axis("E", "Q"), axis("W", "S"));
    const glm::dvec2 turn(axis("Left", "Right"), axis("Up", "Down"));
    if (is_down("Ctrl") || (go == glm::dvec3(0) && turn == glm::dvec2(0)))
        return {};
    const double metres = pace / steps_per_second * (is_down("Shift") ? fast : 1);
    return flown(looked(rig, turn.x * key_turn / steps_per_second, turn.y * key_turn / steps_per_second), go * metres);
}

} // namespace prelight::app::viewer
