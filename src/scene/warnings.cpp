#include <algorithm>
#include <fmt/format.h>
#include <prelight/error.hpp>
#include <scene/warnings.hpp>

namespace prelight {

void Warnings::add(std::string_view kind, std::string_view object, std::string_view reason, uint64_t count) {
    if (strict_)
        throw Error(fmt::format("{}: {}: {}", file_, object, reason));
    auto found = std::ranges::find(kinds_, kind, &Kind::name);
    if (found == kinds_.end())
        found = kinds_.insert(kinds_.end(), {std::string(kind), {}});
    std::vector<Line>& lines = found->lines;
    if (const auto equal = std::ranges::find(lines, reason, &Line::reason); equal != lines.end())
        equal->count += count;
    else if (lines.size() == max_lines)
        lines.back().count += count;
    else
        lines.push_back({std::string(object), std::string(reason), count});
}

std::vector<std::string> Warnings::lines() const {
    std::vector<std::string> out;
    for (const Kind& kind : kinds_)
        for (const Line& line : kind.lines) {
            const bool last = kind.lines.size() == max_lines && &line == &kind.lines.back();
            const std::string number = line.count < 2 ? ""
                                       : last         ? fmt::format(" (and {} more like it)", line.count - 1)
                                                      : fmt::format(" ({} in all)", line.count);
            out.push_back(escaped(fmt::format("{}: {}: {}{}", file_, line.object, line.reason, number)));
        }
    return out;
}

} // namespace prelight
