#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace prelight::materials {

/// Takes words and numbers off the front of a line of GLSL; blanks before them are skipped.
class Scanner {
public:
    explicit Scanner(std::string_view text) : rest_(text) {}
    /// A name; empty, and nothing taken, when something else comes.
    std::string_view word();
    std::optional<float> number();
    /// True, and taken, when the line goes on with `text`.
    bool take(std::string_view text);
    bool done();

private:
    void skip_blanks();
    std::string_view rest_;
};

/// The same text with comments blanked out, line for line.
std::string without_comments(std::string_view source);

} // namespace prelight::materials
