#include "session.hpp"

#include "picker.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <prelight/error.hpp>

namespace prelight::app::viewer {
namespace {

constexpr size_t most_messages = 8;
constexpr double camera_round = 20, object_round = 8, light_round = 12; // seconds for a whole turn

double step_of(double seconds_a_round) { return 2 * std::numbers::pi / (seconds_a_round * steps_per_second); }

} // namespace

Session::Session(const RenderCommand& command, uint32_t width, uint32_t height)
    : reader_(command), scene_(command.scene), width_(width), height_(height), camera_(command.camera),
      moment_(command.moment) {
    input_.resize(width, height);
    look_ = {command.renderer, command.options, command.view};
    load(scene_);
    if (!command.animation.empty())
        animation_ = find_animation(stage_->scene(), command.animation);
    accepted_ = look_;
}

void Session::load(const std::string& scene) {
    const bool same = scene == scene_ && stage_;
    const std::optional<Moment> moment = same || !stage_ ? moment_ : std::nullopt;
    auto next =
        std::make_unique<Stage>(reader_.read(scene, aspect(), moment), reader_.scattered(scene), reader_.frames(scene));
    if (!same && stage_) { // nothing of what was said of the other one holds
        camera_.clear();
        animation_.reset();
        moment_.reset();
        play_from_here();
        follows_ = true;
    }
    if (animation_ && *animation_ >= next->scene().animations.size())
        animation_.reset();
    const PlacedCamera camera = camera_.empty() ? next->world().cameras.at(0) : find_camera(next->world(), camera_);
    scene_ = scene;
    ++loads_;
    if (same) { // what was done to it stays
        next->light_edits = stage_->light_edits;
        next->object_edits = stage_->object_edits;
    }
    if (stage_)
        earlier_.push_back(std::move(stage_));
    stage_ = std::move(next);
    selection_ = {};
    if (!same || follows_)
        show_camera(camera);
    changes_.scene = changes_.lights = changes_.picture = true;
    if (same && (moment_ || !stage_->object_edits.empty()))
        pose();
}

void Session::keep_edit(const SceneEdit& edit) {
    reader_.keep_edit(edit);
    stage_->edit(edit);
}

void Session::forget_earlier() { earlier_.clear(); }

bool Session::go_back(std::string_view reason) {
    if (earlier_.empty())
        return false;
    stage_ = std::move(earlier_.back());
    earlier_.pop_back();
    scene_ = earlier_scene_;
    selection_ = {};
    show_camera(stage_->world().cameras.at(0));
    tell(reason);
    return true;
}

void Session::show_camera(const PlacedCamera& camera) {
    rig_ = rig_of(camera, stage_->world());
    // What it looks at is what it goes round.
    if (const auto hit = hit_by(stage_->world(), ray_through(camera, {0, 0, aspect()})))
        rig_.distance = hit->distance;
    follows_ = true;
    changes_.picture = true;
}

void Session::move_camera(const Rig& rig) {
    rig_ = rig;
    follows_ = false;
    changes_.picture = true;
}

std::vector<PlacedLight> Session::shining() const {
    std::vector<PlacedLight> lights;
    for (LightEdits::Listed& light : stage_->lights())
        if (!only_selected_ || selection_.kind != SelectionKind::light || light.number == selection_.number)
            lights.push_back(std::move(light.placed));
    return lights;
}

uint32_t Session::picture_width() const { return std::max(static_cast<uint32_t>(std::lround(width_ * scale_)), 1u); }

uint32_t Session::picture_height() const { return std::max(static_cast<uint32_t>(std::lround(height_ * scale_)), 1u); }

void Session::pose() {
    stage_->pose(moment_, animation_);
    if (follows_) {
        const PlacedCamera camera =
            camera_.empty() ? stage_->world().cameras.at(0) : find_camera(stage_->world(), camera_);
        const double distance = rig_.distance;
        rig_ = {camera, distance};
    }
    changes_.world = changes_.lights = changes_.picture = true;
}

void Session::step() {
    ++steps_;
    try {
        bool moved = false;
        if (playing_) {
            ++played_;
            const double length = stage_->length(animation_);
            double time = played_from_ + played_ * speed_ / steps_per_second;
            if (length > 0)
                time -= std::floor(time / length) * length;
            moved = stage_->moves();
            if (moved)
                moment_ = Moment{.time = std::max(time, 0.0)};
        }
        if (turn_objects_) {
            stage_->object_edits.turn(step_of(object_round));
            moved = true;
        }
        if (moved)
            pose();
        if (turn_lights_) {
            const World& world = stage_->world();
            stage_->light_edits.turn(step_of(light_round), (world.bounds_min + world.bounds_max) * 0.5);
            changes_.lights = changes_.picture = true;
        }
    } catch (const Error& error) { // a pose that cannot be: what moves stops
        playing_ = turn_objects_ = false;
        tell(error.what());
    }
    if (turn_camera_)
        move_camera(orbited(rig_, step_of(camera_round), 0));
    const World& world = stage_->world();
    const double pace = std::max(glm::length(world.bounds_max - world.bounds_min) / 8, 1e-3); // metres a second
    if (const auto rig = input_.step(rig_, pace))
        move_camera(*rig);
}

void Session::play_from_here() {
    played_from_ = time();
    played_ = 0;
}

void Session::refuse_look(std::string_view reason) {
    look_ = accepted_;
    tell(reason);
}

void Session::tell(std::string_view message) {
    if (!messages_.empty() && messages_.back() == message)
        return;
    messages_.emplace_back(message);
    if (messages_.size() > most_messages)
        messages_.erase(messages_.begin());
}

} // namespace prelight::app::viewer
