#pragma once
#include <map>
#include <prelight/renderer.hpp>
#include <string>

namespace prelight {

/// The settings of one renderer, every key with a value: the default, or what the user asked for.
class Settings {
public:
    /// Throws UsageError: a key that `info` does not list, a value that is not allowed, a view or
    /// preset that does not exist.
    Settings(const RendererInfo& info, const RenderOptions& options);
    const std::string& get(const std::string& key) const { return values_.at(key); }
    bool is(const std::string& key, const std::string& value) const { return get(key) == value; }
    double number(const std::string& key) const;
    const std::map<std::string, std::string>& all() const { return values_; }
    /// Replaces "auto" by what the renderer chose, so that the figures name it.
    void resolve(const std::string& key, const std::string& value) { values_.at(key) = value; }

private:
    std::map<std::string, std::string> values_;
};

} // namespace prelight
