#pragma once
#include <prelight/export.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace prelight {

/// Text fit for one line of a terminal: control characters, bytes that are no UTF-8 and characters that
/// turn the direction of text are written as escapes (`\n`, `\x1b`, `\u202e`). What has been escaped stays as it is.
PRELIGHT_API std::string escaped(std::string_view text);

/// The work failed: a bad scene, a lost device, no memory. `what()` is one line, escaped, that names the file
/// (or device), the object in it, and the reason. The program ends with exit status 1.
class PRELIGHT_API Error : public std::runtime_error {
public:
    /// The message is escaped() first.
    explicit Error(std::string_view message) : std::runtime_error(escaped(message)) {}
};

/// The device stopped working (VK_ERROR_DEVICE_LOST): nothing that was made on it can be used any more, and another
/// one may well be made.
class PRELIGHT_API DeviceLost : public Error {
public:
    using Error::Error; ///< as Error
};

/// The request itself was wrong: an unknown setting, a value out of range, a combination that no
/// renderer offers. The program ends with exit status 2.
class PRELIGHT_API UsageError : public Error {
public:
    using Error::Error; ///< as Error
};

} // namespace prelight
