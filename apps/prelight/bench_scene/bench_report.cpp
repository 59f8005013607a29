// `prelight bench report`: the page of saved figures.
#include "bench_scene.hpp"
#include "saved_bench.hpp"

#include "log.hpp"
#include "output.hpp"
#include "page.hpp"

#include <array>
#include <fmt/format.h>

namespace prelight::app {

void bench_report(const BenchCommand& command) {
    check_distinct(std::array{command.output}, command.files);
    check_writable(command.output);
    nlohmann::ordered_json files = nlohmann::ordered_json::array();
    size_t runs = 0;
    for (const std::filesystem::path& file : command.files) {
        SavedBench bench = load_bench(file);
        runs += bench.runs.size();
        files.push_back({{"file", file.filename().string()}, {"bench", std::move(bench.json)}});
    }
    save_text(fill_page(bench_page, files), command.output);
    tell(fmt::format("{}: {} run(s) of {} file(s)", command.output.string(), runs, command.files.size()));
}

} // namespace prelight::app
