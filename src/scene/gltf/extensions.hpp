#pragma once
#include <span>
#include <string_view>

namespace prelight::gltf {

/// How far an extension's text is followed.
enum class Honoured { whole, partly, not_at_all };

struct Extension {
    std::string_view name;
    Honoured honoured = Honoured::not_at_all;
    std::string_view how; ///< what becomes of it, or what is missing: one line
};

/// What is read. A file that requires another cannot be.
std::span<const Extension> known_extensions();
/// Its row, or one that says that it is not known.
Extension find_extension(std::string_view name);

} // namespace prelight::gltf
