// What each event does.
#include "keys.hpp"
#include "picker.hpp"
#include "session.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <map>
#include <prelight/error.hpp>
#include <prelight/views.hpp>

namespace prelight::app::viewer {

/// Each takes an event that check_event() has let through.
struct Handlers {
    using Handler = void (*)(Session&, const Event&);
    static const std::map<std::string_view, Handler>& all();

    static void dirty_lights(Session& s, bool known, const Event& event) {
        if (!known)
            throw Error(fmt::format("{} {}: no such light", event.verb, event.words[0]));
        s.changes_.lights = s.changes_.picture = true;
    }
    static void dirty_look(Session& s) { s.changes_.look = s.changes_.picture = true; }
    static const RendererInfo info(const std::string& name) {
        for (RendererInfo& one : renderer_infos())
            if (one.name == name)
                return one;
        throw Error(fmt::format("renderer {}: no such renderer", name));
    }

    static void use_renderer(Session& s, const std::string& name) {
        const RendererInfo next = info(name);
        s.look_.renderer = name;
        // Settings that both have stay, with values that both allow.
        std::erase_if(s.look_.options.settings, [&](const auto& setting) {
            return std::ranges::find(next.settings, setting.first, &SettingInfo::key) == next.settings.end();
        });
        if (std::ranges::find(next.presets, s.look_.options.preset) == next.presets.end())
            s.look_.options.preset.clear();
        if (s.look_.buffer != "final" && !has_view(next, s.look_.buffer))
            s.show_buffer("final");
        dirty_look(s);
    }

    static void drop(Session& s, const std::string& file) {
        const std::string ending = lower_ending(file);
        if (ending == ".hdr" || ending == ".exr" || ending == ".png") {
            s.reader_.take_environment(file);
            s.load(s.scene_);
        } else {
            s.load(file);
        }
    }
    static std::string lower_ending(const std::string& file) {
        std::string ending = std::filesystem::path(file).extension().string();
        std::ranges::transform(ending, ending.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
        return ending;
    }

    static void pick_light(Session& s, double x, double y) {
        const auto lights = s.stage_->lights();
        if (lights.empty())
            throw Error("there is no light to select");
        const bool again = s.picked_at_ == glm::dvec2(x, y) && s.selection_.kind == SelectionKind::light;
        if (!again)
            s.pick_order_ = lights_near(lights, s.camera(), s.point(x, y));
        s.picked_at_ = {x, y};
        auto next = s.pick_order_.begin();
        if (again) {
            const auto now = std::ranges::find(s.pick_order_, s.selection_.number);
            next = now == s.pick_order_.end() || now + 1 == s.pick_order_.end() ? s.pick_order_.begin() : now + 1;
        }
        select(s, {SelectionKind::light, *next});
    }
    static void pick_object(Session& s, double x, double y) {
        const auto hit = hit_by(s.stage_->world(), ray_through(s.camera(), s.point(x, y)));
        select(s,
               hit ? Selection{SelectionKind::object, s.stage_->world().instances[hit->instance].node} : Selection{});
    }
    static void select(Session& s, Selection selection) {
        s.selection_ = selection;
        if (s.only_selected_)
            s.changes_.lights = s.changes_.picture = true;
    }
    static void select_light(Session& s, uint32_t number) {
        if (!s.stage_->light(number))
            throw Error(fmt::format("light {}: there is none", number));
        select(s, {SelectionKind::light, number});
    }
    static void check_object(const Session& s, uint32_t node) {
        const auto& instances = s.stage_->world().instances;
        if (std::ranges::find(instances, node, &Instance::node) == instances.end())
            throw Error(fmt::format("object {}: there is none", node));
    }

    static void select_object(Session& s, uint32_t node) {
        check_object(s, node);
        select(s, {SelectionKind::object, node});
    }

    static void add_light(Session& s) {
        const World& world = s.stage_->world();
        const auto hit = hit_by(world, ray_through(s.camera(), {0, 0, s.aspect()}));
        const double size = std::max(glm::length(world.bounds_max - world.bounds_min), 1e-3);
        PlacedLight light;
        light.light.name = "added";
        light.light.range = static_cast<float>(size / 3);
        light.light.intensity = light.light.range * light.light.range / 10;
        // A little off the surface, towards the camera.
        light.position =
            hit ? hit->position - s.rig_.forward() * std::min(size / 15, hit->distance / 2) : s.rig_.pivot();
        const uint32_t number = s.stage_->light_edits.add(s.stage_->own_lights(), light);
        s.changes_.lights = s.changes_.picture = true;
        select(s, {SelectionKind::light, number});
    }
    static void remove_light(Session& s, uint32_t number, const Event& event) {
        dirty_lights(s, s.stage_->light_edits.remove(s.stage_->own_lights(), number), event);
        if (s.selection_.kind == SelectionKind::light && s.selection_.number == number)
            s.selection_ = {};
    }

    static void cycle_materials(Session& s) {
        const auto node =
            s.selection_.kind == SelectionKind::object ? std::optional(s.selection_.number) : std::nullopt;
        if (!s.stage_->next_material(node))
            throw Error("there is no other material that fits");
        s.pose();
    }

    static void at_time(Session& s, double seconds) {
        s.moment_ = Moment{.time = std::max(seconds, 0.0)};
        s.play_from_here();
        s.pose();
    }
    static void frame_all(Session& s) { s.move_camera(framed(s.rig_, s.stage_->world(), s.aspect())); }
    static void resize(Session& s, uint32_t width, uint32_t height) {
        s.width_ = width;
        s.height_ = height;
        s.input_.resize(width, height);
        s.changes_.size = s.changes_.picture = true;
    }
    static void reload(Session& s) {
        for (const std::string& mistake : s.reader_.take_changes())
            s.tell(mistake);
        s.load(s.scene_);
    }
};

const std::map<std::string_view, Handlers::Handler>& Handlers::all() {
    using S = Session;
    using E = Event;
    const static std::map<std::string_view, Handler> table{
        {"key", [](S& s, const E& e) { s.take_key(e.words[0], e.words[1] == "down"); }},
        {"button",
         [](S& s, const E& e) {
             if (s.input_.button(e.words[0], e.words[1] == "down", e.number(2), e.number(3)))
                 pick_object(s, e.number(2), e.number(3));
         }},
        {"move",
         [](S& s, const E& e) {
             if (const auto rig = s.input_.move(s.rig_, e.number(0), e.number(1)))
                 s.move_camera(*rig);
         }},
        {"wheel",
         [](S& s, const E& e) { s.move_camera(s.input_.wheel(s.rig_, std::clamp(e.number(1), -50.0, 50.0))); }},
        {"leave", [](S& s, const E&) { s.input_.release_all(); }},
        {"drop", [](S& s, const E& e) { drop(s, e.words[0]); }},
        {"resize", [](S& s, const E& e) { resize(s, e.count(0), e.count(1)); }},
        {"scale",
         [](S& s, const E& e) {
             s.scale_ = std::clamp(e.number(0), 0.1, 1.0);
             s.changes_.size = s.changes_.picture = true;
         }},
        {"renderer", [](S& s, const E& e) { use_renderer(s, e.words[0]); }},
        {"preset",
         [](S& s, const E& e) {
             s.look_.options.preset = e.words[0];
             dirty_look(s);
         }},
        {"set",
         [](S& s, const E& e) {
             s.look_.options.settings[e.words[0]] = e.words[1];
             dirty_look(s);
         }},
        {"unset",
         [](S& s, const E& e) {
             s.look_.options.settings.erase(e.words[0]);
             dirty_look(s);
         }},
        {"shading",
         [](S& s, const E& e) {
             s.look_.options.shading.reset();
             if (!e.words[0].empty())
                 s.look_.options.shading = e.words[0] == "phong" ? Shading::phong : Shading::ggx;
             dirty_look(s);
         }},
        {"tonemap",
         [](S& s, const E& e) {
             s.look_.options.tonemap = e.words[0] == "aces"   ? Tonemap::aces
                                       : e.words[0] == "none" ? Tonemap::none
                                                              : Tonemap::pbr_neutral;
             dirty_look(s);
         }},
        {"exposure",
         [](S& s, const E& e) {
             s.look_.options.exposure = std::clamp(e.number(0), -64.0, 64.0);
             dirty_look(s);
         }},
        {"buffer", [](S& s, const E& e) { s.show_buffer(e.words[0]); }},
        {"camera",
         [](S& s, const E& e) {
             const PlacedCamera camera = find_camera(s.stage_->world(), e.words[0]);
             s.camera_ = e.words[0];
             s.show_camera(camera);
         }},
        {"frame", [](S& s, const E&) { frame_all(s); }},
        {"play",
         [](S& s, const E& e) {
             s.playing_ = e.turned(0, s.playing_);
             s.play_from_here();
         }},
        {"time", [](S& s, const E& e) { at_time(s, e.number(0)); }},
        {"speed",
         [](S& s, const E& e) {
             s.play_from_here();
             s.speed_ = std::clamp(e.number(0), -100.0, 100.0);
         }},
        {"animation",
         [](S& s, const E& e) {
             s.animation_.reset();
             if (!e.words[0].empty())
                 s.animation_ = find_animation(s.stage_->scene(), e.words[0]);
             at_time(s, 0);
         }},
        {"turn-camera", [](S& s, const E& e) { s.turn_camera_ = e.turned(0, s.turn_camera_); }},
        {"turn-objects", [](S& s, const E& e) { s.turn_objects_ = e.turned(0, s.turn_objects_); }},
        {"turn-lights", [](S& s, const E& e) { s.turn_lights_ = e.turned(0, s.turn_lights_); }},
        {"cycle-materials", [](S& s, const E&) { cycle_materials(s); }},
        {"select-light", [](S& s, const E& e) { select_light(s, e.count(0)); }},
        {"select-object", [](S& s, const E& e) { select_object(s, e.count(0)); }},
        {"select-none", [](S& s, const E&) { select(s, {}); }},
        {"pick-light", [](S& s, const E& e) { pick_light(s, e.number(0), e.number(1)); }},
        {"pick-object", [](S& s, const E& e) { pick_object(s, e.number(0), e.number(1)); }},
        {"move-light",
         [](S& s, const E& e) {
             const glm::dvec3 by(e.number(1), e.number(2), e.number(3));
             dirty_lights(s, s.stage_->light_edits.move(s.stage_->own_lights(), e.count(0), by), e);
         }},
        {"move-object",
         [](S& s, const E& e) {
             check_object(s, e.count(0));
             s.stage_->object_edits.move(e.count(0), {e.number(1), e.number(2), e.number(3)});
             s.pose();
         }},
        {"light-colour",
         [](S& s, const E& e) {
             const glm::vec3 rgb(e.number(1), e.number(2), e.number(3));
             dirty_lights(s, s.stage_->light_edits.colour(s.stage_->own_lights(), e.count(0), rgb), e);
         }},
        {"light-intensity",
         [](S& s, const E& e) {
             const auto value = static_cast<float>(e.number(1));
             dirty_lights(s, s.stage_->light_edits.intensity(s.stage_->own_lights(), e.count(0), value), e);
         }},
        {"light-range",
         [](S& s, const E& e) {
             const auto metres = static_cast<float>(e.number(1));
             dirty_lights(s, s.stage_->light_edits.range(s.stage_->own_lights(), e.count(0), metres), e);
         }},
        {"add-light", [](S& s, const E&) { add_light(s); }},
        {"remove-light", [](S& s, const E& e) { remove_light(s, e.count(0), e); }},
        {"remove-selected",
         [](S& s, const E& e) {
             if (s.selection_.kind != SelectionKind::light)
                 throw Error("no light is selected");
             remove_light(s, s.selection_.number, e);
         }},
        {"random-lights",
         [](S& s, const E&) {
             s.stage_->light_edits.randomise(s.stage_->own_lights(), ++s.random_);
             s.changes_.lights = s.changes_.picture = true;
         }},
        {"only-selected",
         [](S& s, const E& e) {
             s.only_selected_ = e.turned(0, s.only_selected_);
             s.changes_.lights = s.changes_.picture = true;
         }},
        {"reload", [](S& s, const E&) { reload(s); }},
        {"screenshot", [](S& s, const E& e) { s.screenshots_.push_back(e.words[0]); }},
        {"help", [](S& s, const E& e) { s.help_ = e.turned(0, s.help_); }},
        {"panels", [](S& s, const E& e) { s.panels_ = e.turned(0, s.panels_); }},
        {"lose", [](S& s, const E& e) { s.loss_ = e.words[0]; }},
        {"quit", [](S& s, const E&) { s.done_ = true; }},
    };
    return table;
}

void Session::apply(const Event& event) {
    try {
        check_event(event);
        Handlers::all().at(event.verb)(*this, event);
    } catch (const Error& error) {
        tell(error.what());
    }
}

void Session::take_key(const std::string& key, bool down) {
    input_.key(key, down);
    if (!down)
        return;
    if (key == "Escape" && help_) {
        help_ = false;
        return;
    }
    for (const KeyBinding& binding : key_bindings())
        for (const std::string& text : binding.key == key ? binding.events : std::vector<std::string>{}) {
            Event event = parse_event(fmt::format(
                "{} {}", steps_,
                text.ends_with("$x $y")
                    ? fmt::format("{}{} {}", text.substr(0, text.size() - 5), input_.mouse().x, input_.mouse().y)
                    : text));
            // The same key again: back to the picture.
            if (event.verb == "buffer" && event.words[0] == look_.buffer)
                event.words[0] = "final";
            apply(event);
        }
}

void Session::show_buffer(const std::string& name) {
    const RendererInfo info = Handlers::info(look_.renderer);
    if (name != "final" && (name == "linear" || !has_view(info, name)))
        throw Error(fmt::format("{} has no buffer {} ({})", info.name, name, names_of_views(info)));
    look_.buffer = name;
    look_.options.views = {name};
    changes_.look = changes_.picture = true;
}

} // namespace prelight::app::viewer
