#include "validation.hpp"

#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight::app {

void check_validation(const Device& device) {
    const std::vector<std::string> messages = device.validation_messages();
    for (const std::string& message : messages)
        fmt::print(stderr, "validation: {}\n", message);
    if (!messages.empty())
        throw Error(fmt::format("{}: {} validation message{}", device.name(), messages.size(),
                                messages.size() == 1 ? "" : "s"));
}

} // namespace prelight::app
