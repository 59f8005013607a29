#pragma once
#include <stdexcept>
#include <string>

namespace prelight {

/// The work failed: a bad scene, a lost device, no memory. `what()` is one line that names the file
/// (or device), the object in it, and the reason. The program ends with exit status 1.
class Error : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The request itself was wrong: an unknown setting, a value out of range, a combination that no
/// renderer offers. The program ends with exit status 2.
class UsageError : public Error {
public:
    using Error::Error;
};

} // namespace prelight
