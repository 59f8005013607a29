#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace prelight::app {

/// The name of a series of files, as in "out/night.####.png": the run of # in the file's name stands for the frame's
/// number, with zeros in front up to as many digits. A name without # is one file.
class NumberedName {
public:
    NumberedName() = default;
    /// Throws UsageError: more than one run of #, or one in the name of a folder.
    NumberedName(std::string_view option, const std::filesystem::path& pattern);

    const std::filesystem::path& pattern() const { return pattern_; }
    bool numbered() const { return digits_ > 0; }
    std::filesystem::path at(uint32_t frame) const;

private:
    std::filesystem::path pattern_, folder_;
    std::string before_, after_; ///< in the file's name
    size_t digits_ = 0;
};

} // namespace prelight::app
