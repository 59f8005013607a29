#include "sequence/numbered_name.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <prelight/error.hpp>

namespace prelight::app {

NumberedName::NumberedName(std::string_view option, const std::filesystem::path& pattern)
    : pattern_(pattern), folder_(pattern.parent_path()), before_(pattern.filename().string()) {
    if (folder_.string().find('#') != std::string::npos)
        throw UsageError(fmt::format("{} {}: # stands for a frame's number in a file's name, not in a folder's", option,
                                     pattern.string()));
    const std::string name = before_;
    const size_t percent = name.find('%');
    const size_t letter = percent == std::string::npos ? percent : name.find_first_not_of("0123456789", percent + 1);
    if (letter != std::string::npos && name[letter] == 'd')
        throw UsageError(
            fmt::format("{} {}: the frame's number is written as #, as in out.####.png", option, pattern.string()));
    const size_t first = name.find('#');
    if (first == std::string::npos)
        return;
    const size_t end = std::min(name.find_first_not_of('#', first), name.size());
    digits_ = end - first;
    before_ = name.substr(0, first);
    after_ = name.substr(end);
    if (after_.find('#') != std::string::npos)
        throw UsageError(fmt::format("{} {}: more than one run of #", option, pattern.string()));
}

std::filesystem::path NumberedName::at(uint32_t frame) const {
    return digits_ == 0 ? pattern_ : folder_ / fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

} // namespace prelight::app
