#pragma once
#include <map>
#include <prelight/renderer.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace prelight::app {

/// One way to render: an architecture by itself, or with a preset or settings.
struct Variant {
    std::string renderer;
    std::string preset; ///< empty: none
    std::map<std::string, std::string> settings;

    /// As `--renderers` takes it: "deferred", "light-prepass@preset=engel", "multipass@order=objects".
    std::string name() const;
    bool operator==(const Variant&) const = default;
};

/// "a,b@key=value,c@key=value@key2=value2": architectures with their settings; the key `preset` names
/// a preset. Throws UsageError: not of that form, or an architecture, key, value or preset that does
/// not exist, or the same variant twice.
std::vector<Variant> parse_variants(std::string_view option, const std::string& text);

/// What `compare` shows when nothing is named: each architecture but the reference by itself, with
/// each of its presets, and with a few settings that change what a light costs.
std::vector<Variant> standard_variants(const std::vector<RendererInfo>& infos);

} // namespace prelight::app
