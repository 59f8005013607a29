#include <prelight/version.hpp>

#define TEXT(value) #value
#define DOTTED(major, minor, patch) TEXT(major) "." TEXT(minor) "." TEXT(patch)

namespace prelight {

std::string_view version() { return DOTTED(PRELIGHT_VERSION_MAJOR, PRELIGHT_VERSION_MINOR, PRELIGHT_VERSION_PATCH); }

} // namespace prelight

#undef TEXT
#undef DOTTED
