#include "report.hpp"
#include "report_page_parts.hpp"

#include <nlohmann/json.hpp>

namespace prelight::app {
namespace {

void put(std::string& page, std::string_view mark, std::string_view text) {
    page.replace(page.find(mark), mark.size(), text);
}

/// JSON that stands inside <script>: no text in it can end the element or begin a comment.
std::string inside_script(const nlohmann::ordered_json& json) {
    std::string safe;
    for (const char c :
         json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    return safe;
}

} // namespace

std::string report_page(const nlohmann::ordered_json& report) {
    std::string page(report_html);
    // The data comes last: nothing in it is taken for a mark.
    put(page, "{{style}}", report_style);
    put(page, "{{script}}", report_script);
    put(page, "{{data}}", inside_script(report));
    return page;
}

} // namespace prelight::app
