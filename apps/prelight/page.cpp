#include "page.hpp"

#include <nlohmann/json.hpp>

namespace prelight::app {
namespace {

void put(std::string& page, std::string_view mark, std::string_view text) {
    page.replace(page.find(mark), mark.size(), text);
}

/// JSON that stands inside <script>: no text in it can end the element or begin a comment.
std::string inside_script(const nlohmann::ordered_json& json) {
    std::string safe;
    for (const char c : json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    return safe;
}

} // namespace

std::string fill_page(const Page& page, const nlohmann::ordered_json& data) {
    std::string text(page.html);
    // The data comes last: nothing in it is taken for a mark.
    put(text, "{{style}}", page.style);
    put(text, "{{script}}", page.script);
    put(text, "{{data}}", inside_script(data));
    return text;
}

} // namespace prelight::app
