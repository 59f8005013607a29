#include "scanner.hpp"
#include <charconv>

namespace prelight::materials {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

} // namespace

void Scanner::skip_blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\t' || rest_.front() == '\r'))
        rest_.remove_prefix(1);
}

std::string_view Scanner::word() {
    skip_blanks();
    size_t length = 0;
    while (length < rest_.size() && (is_letter(rest_[length]) || (length > 0 && is_digit(rest_[length]))))
        ++length;
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return taken;
}

std::optional<float> Scanner::number() {
    skip_blanks();
    float value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc())
        return {};
    rest_.remove_prefix(static_cast<size_t>(end - rest_.data()));
    if (!rest_.empty() && (rest_.front() == 'f' || rest_.front() == 'F'))
        rest_.remove_prefix(1);
    return value;
}

bool Scanner::take(std::string_view text) {
    skip_blanks();
    if (!rest_.starts_with(text))
        return false;
    rest_.remove_prefix(text.size());
    return true;
}

bool Scanner::done() {
    skip_blanks();
    return rest_.empty();
}

std::string without_comments(std::string_view source) {
    std::string text(source);
    enum { code, line, block } state = code;
    for (size_t i = 0; i < text.size(); ++i) {
        const bool pair = i + 1 < text.size();
        if (state == code && pair && text[i] == '/' && (text[i + 1] == '/' || text[i + 1] == '*')) {
            state = text[i + 1] == '/' ? line : block;
            text[i] = text[i + 1] = ' ';
            ++i;
        } else if (state == block && pair && text[i] == '*' && text[i + 1] == '/') {
            state = code;
            text[i] = text[i + 1] = ' ';
            ++i;
        } else if (text[i] == '\n') {
            state = state == line ? code : state;
        } else if (state != code) {
            text[i] = ' ';
        }
    }
    return text;
}

} // namespace prelight::materials
