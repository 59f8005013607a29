#pragma once
#include <map>
#include <prelight/renderer.hpp>
#include <set>
#include <setting_values/choices.hpp>
#include <string>
#include <vector>

namespace prelight {

/// The settings of one renderer, every key with a value: the default, or what the user asked for.
class Settings {
public:
    /// Defaults, then the preset's settings, then the user's. Throws UsageError: a key that `info` does not list, a
    /// value that is not allowed, a view or preset that does not exist.
    Settings(const RendererInfo& info, const RenderOptions& options);
    const std::string& get(const std::string& key) const { return values_.at(key); }
    /// The user asked for it: it is neither a default nor a preset's.
    bool given(const std::string& key) const { return given_.contains(key); }
    bool is(const std::string& key, const std::string& value) const { return get(key) == value; }
    double number(const std::string& key) const;
    /// What the setting's word means. Throws Error: "auto" that nobody has resolved.
    template <class T>
    T value(const ChoiceSetting<T>& setting) const {
        return setting.value(get(setting.key));
    }
    template <class T>
    void resolve(const ChoiceSetting<T>& setting, T value) {
        resolve(setting.key, setting.word(value));
    }
    bool has(const std::string& key) const { return values_.contains(key); }
    const std::map<std::string, std::string>& all() const { return values_; }
    /// The lighting model in force.
    Shading shading() const { return shading_; }
    /// Throws UsageError for what the user changed that makes no difference with all that is in force, and says what it
    /// needs. What only a preset brought gives way to the default, with a note.
    void refuse_without_effect();
    /// Replaces "auto" by what the renderer chose, so that the figures name it.
    void resolve(const std::string& key, const std::string& value) { values_.at(key) = value; }
    /// What is not as a preset asked for, one line each: Stats::notes.
    void note(std::string text) { notes_.push_back(std::move(text)); }
    const std::vector<std::string>& notes() const { return notes_; }

private:
    void set(const RendererInfo& info, const std::map<std::string, std::string>& settings);
    std::map<std::string, std::string> values_, defaults_;
    std::set<std::string> given_;
    std::string preset_;
    std::set<std::string> of_preset_; ///< keys that it sets
    std::vector<std::string> views_;
    Shading shading_;
    std::vector<std::string> notes_;
};

} // namespace prelight
