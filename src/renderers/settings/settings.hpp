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
    /// Puts `value` in the place of "auto", or of what cannot be. `why`: a phrase, for choices().
    void resolve(const std::string& key, const std::string& value, const std::string& why);
    template <class T>
    void resolve(const ChoiceSetting<T>& setting, T value, const std::string& why) {
        resolve(setting.key, setting.word(value), why);
    }
    /// The same where a value was asked for by name: a line of notes() says so.
    void fall_back(const std::string& key, const std::string& value, const std::string& why);
    bool has(const std::string& key) const { return values_.contains(key); }
    const std::map<std::string, std::string>& all() const { return values_; }
    /// The lighting model in force.
    Shading shading() const { return shading_; }
    /// Throws UsageError for what the user changed that makes no difference with all that is in force, and says what it
    /// needs. What only a preset brought gives way to the default, with a note.
    void refuse_without_effect();
    /// What resolve() and fall_back() replaced.
    std::vector<SettingChoice> choices() const;
    /// What is not as asked for, one line each: Stats::notes.
    const std::vector<std::string>& notes() const { return notes_; }

private:
    void set(const RendererInfo& info, const std::map<std::string, std::string>& settings);
    std::map<std::string, std::string> values_, defaults_;
    std::set<std::string> given_;
    std::string preset_;
    std::set<std::string> of_preset_; ///< keys that it sets
    std::vector<std::string> views_;
    Shading shading_;
    uint32_t msaa_;
    std::map<std::string, SettingChoice> choices_;
    std::vector<std::string> notes_;
};

} // namespace prelight
