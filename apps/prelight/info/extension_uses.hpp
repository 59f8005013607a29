#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace prelight::app {

/// What a glTF text says of itself and of its extensions.
struct ExtensionUses {
    struct Use {
        uint64_t objects = 0;  ///< that have the extension
        bool required = false; ///< the file cannot be shown without it
    };
    std::map<std::string, Use>
        extensions;                 ///< those of extensionsUsed and extensionsRequired, and any that an object has
    std::string generator, version; ///< of its asset; may be empty
};

/// Looks through the text, which need not be whole or right.
ExtensionUses extension_uses(std::string_view json);

} // namespace prelight::app
