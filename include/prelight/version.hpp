#pragma once
#include <prelight/export.hpp>
#include <string_view>

// The version of these headers, the one place for it: CMakeLists.txt reads the numbers here. What each promises stands
// in docs/embedding.md.
#define PRELIGHT_VERSION_MAJOR 0
#define PRELIGHT_VERSION_MINOR 2
#define PRELIGHT_VERSION_PATCH 0
/// The shared library's interface, the number in libprelight.so.N: programs built for another one do not start.
#define PRELIGHT_SOVERSION 0

#define PRELIGHT_MAKE_VERSION(major, minor, patch) ((major)*10000 + (minor)*100 + (patch))
/// For the preprocessor: #if PRELIGHT_VERSION >= PRELIGHT_MAKE_VERSION(0, 2, 0)
#define PRELIGHT_VERSION PRELIGHT_MAKE_VERSION(PRELIGHT_VERSION_MAJOR, PRELIGHT_VERSION_MINOR, PRELIGHT_VERSION_PATCH)

/// A renderer for scenes with very many lights. A Scene is resolved into a World, which a Renderer on a Device draws.
namespace prelight {

/// The version of the library that runs, "MAJOR.MINOR.PATCH". A shared one may be newer than these headers.
PRELIGHT_API std::string_view version();

} // namespace prelight
