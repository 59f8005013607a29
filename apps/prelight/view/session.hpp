#pragma once
#include "input.hpp"
#include "stage.hpp"

namespace prelight::app::viewer {

/// What a renderer is made for.
struct Look {
    std::string renderer = "light-prepass";
    RenderOptions options; ///< width and height are the session's
    std::string buffer = "final";
};

/// What has changed since a renderer last looked.
struct Changes {
    bool look = false;                                                 ///< another renderer is needed
    bool scene = false;                                                ///< the stage is another
    bool world = false, lights = false, size = false, picture = false; ///< picture: a frame is due
    bool any() const { return look || scene || world || lights || size || picture; }
};

enum class SelectionKind { none, light, object };
struct Selection {
    SelectionKind kind = SelectionKind::none;
    uint32_t number = 0; ///< of a light, or of an object's node
};

/// What the window shows, without a window: events go in, a state comes out, step by step of a fixed length. The same
/// events at the same steps give the same state, whoever sends them.
class Session {
public:
    /// Reads the scene. Throws Error.
    Session(const RenderCommand& command, uint32_t width, uint32_t height);

    /// Changes the environment of the scene that the command names, before anybody looks at it and when it is read
    /// again.
    void keep_edit(const SceneEdit& edit);

    /// Takes an event. What cannot be done is told in messages() and changes nothing.
    void apply(const Event& event);
    /// A step of the clock.
    void step();
    uint32_t steps() const { return steps_; }

    const Stage& stage() const { return *stage_; }
    const PlacedCamera& camera() const { return rig_.camera; }
    const Rig& rig() const { return rig_; }
    /// That shine now.
    std::vector<PlacedLight> shining() const;
    const Look& look() const { return look_; }
    uint32_t window_width() const { return width_; }
    uint32_t window_height() const { return height_; }
    bool minimised() const { return width_ == 0 || height_ == 0; }
    /// Pixels that are drawn.
    uint32_t picture_width() const;
    uint32_t picture_height() const;
    double aspect() const { return input_.aspect(); }
    double scale() const { return scale_; }
    PicturePoint point(double x, double y) const { return input_.point(x, y); }
    glm::dvec2 mouse() const { return input_.mouse(); }

    bool playing() const { return playing_; }
    double time() const { return moment_ ? moment_->time : 0; }
    double speed() const { return speed_; }
    std::optional<uint32_t> animation() const { return animation_; }
    Selection selection() const { return selection_; }
    bool only_selected() const { return only_selected_; }
    bool turns_camera() const { return turn_camera_; }
    bool turns_objects() const { return turn_objects_; }
    bool turns_lights() const { return turn_lights_; }
    bool shows_help() const { return help_; }
    bool shows_panels() const { return panels_; }
    bool done() const { return done_; }
    const std::string& scene_name() const { return scene_; }
    /// Files of the scene and what belongs to it: one that changes is a reason to reload.
    std::vector<std::filesystem::path> files() const { return reader_.files(scene_); }
    /// Another one after each time that files were read: files() may be others.
    uint32_t loads() const { return loads_; }

    /// For who draws.
    Changes take_changes() { return std::exchange(changes_, {}); }
    const Changes& changes() const { return changes_; }
    /// A frame is due, though nothing has changed.
    void need_picture() { changes_.picture = true; }
    /// All is due again: after a loss.
    void renew() { changes_ = {true, true, true, true, true, true}; }
    /// The look can be had; or cannot, and the last one that could stays.
    void accept_look() { accepted_ = look_; }
    void refuse_look(std::string_view reason);
    Stage& stage() { return *stage_; }
    /// No renderer looks at another scene any more.
    void forget_earlier();
    /// The scene from before the last one, which no renderer can show. False: there is none.
    bool go_back(std::string_view reason);

    /// Lines for a person, the last ones last: what went wrong, and what was written.
    const std::vector<std::string>& messages() const { return messages_; }
    void tell(std::string_view message);
    void dismiss_messages() { messages_.clear(); }

    /// What somebody outside has to do: file names of screenshots, losses that a test wants.
    bool wants_screenshots() const { return !screenshots_.empty(); }
    std::vector<std::string> take_screenshots() { return std::exchange(screenshots_, {}); }
    std::string take_loss() { return std::exchange(loss_, {}); }

private:
    friend struct Handlers; // session_events.cpp
    void load(const std::string& scene);
    void show_camera(const PlacedCamera& camera);
    void move_camera(const Rig& rig);
    void pose();
    /// Time is counted in whole steps from where playing began: sums of rounded steps would drift.
    void play_from_here();
    void take_key(const std::string& key, bool down);
    void show_buffer(const std::string& name);

    SceneReader reader_;
    std::string scene_;
    uint32_t loads_ = 0;
    std::unique_ptr<Stage> stage_;
    std::vector<std::unique_ptr<Stage>> earlier_; ///< which a renderer may still look at
    std::string earlier_scene_;                   ///< of the last of them
    uint32_t width_, height_;
    double scale_ = 1;
    uint32_t steps_ = 0;
    Input input_;
    Rig rig_;
    std::string camera_;  ///< of the scene, by name or index; empty: the first
    bool follows_ = true; ///< the scene's camera; false: it was moved by hand
    Look look_, accepted_;
    std::optional<Moment> moment_; ///< absent: at rest
    std::optional<uint32_t> animation_;
    double speed_ = 1, played_from_ = 0; ///< seconds
    uint32_t played_ = 0;                ///< steps since then
    bool playing_ = false, turn_camera_ = false, turn_objects_ = false, turn_lights_ = false;
    bool only_selected_ = false, help_ = false, panels_ = true, done_ = false;
    uint32_t random_ = 0; ///< how often lights were made random
    Selection selection_;
    std::vector<uint32_t> pick_order_; ///< of lights, while the same place is picked again
    glm::dvec2 picked_at_{-1};
    Changes changes_{true, true, true, true, true, true};
    std::vector<std::string> messages_, screenshots_;
    std::string loss_;
};

} // namespace prelight::app::viewer
