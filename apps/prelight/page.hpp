#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace prelight::app {

/// The files of a page, embedded when the program is built (apps/prelight/report/).
struct Page {
    std::string_view html, style, script;
};
extern const Page report_page; ///< of `compare`
extern const Page bench_page;  ///< of `bench report`

/// A page with its style, its program and `data` inside: it needs no other file.
std::string fill_page(const Page& page, const nlohmann::ordered_json& data);

} // namespace prelight::app
