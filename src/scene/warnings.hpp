#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace prelight {

/// What is wrong with a file and costs one object alone: repaired or left out by whoever reads it, and told here.
/// Equal warnings become one line, "FILE: OBJECT: REASON (N in all)", that names the first object. Of a kind whose
/// reasons differ (other numbers, other files) the first eight have lines of their own.
class Warnings {
public:
    /// `strict`: the first warning is an Error.
    explicit Warnings(std::string file, bool strict = false) : file_(std::move(file)), strict_(strict) {}

    const std::string& file() const { return file_; }
    /// `kind`: what such warnings share, whatever numbers and names their `reason` holds; there are few kinds.
    /// `count`: of this object. Throws Error "FILE: OBJECT: REASON" when strict.
    void add(std::string_view kind, std::string_view object, std::string_view reason, uint64_t count = 1);
    std::vector<std::string> lines() const;

private:
    struct Line {
        std::string object, reason;
        uint64_t count = 0;
    };
    struct Kind {
        std::string name;
        std::vector<Line> lines; ///< the last of max_lines stands for all further ones
    };
    static constexpr size_t max_lines = 8;
    std::string file_;
    bool strict_;
    std::vector<Kind> kinds_;
};

} // namespace prelight
