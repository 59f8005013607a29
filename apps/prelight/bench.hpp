#pragma once
#include "command_line.hpp"

#include <nlohmann/json.hpp>
#include <prelight/device.hpp>

namespace prelight::app {

/// One table of `prelight bench`. To add one: a file bench_NAME.cpp, a declaration here, a line in
/// bench.cpp.
struct Bench {
    const char* name;
    const char* description;
    /// Prints the table; what it returns becomes part of the JSON file. Throws Error.
    nlohmann::ordered_json (*run)(const BenchCommand& command, Device& device);
    uint32_t width = 640, height = 360; ///< unless the user says otherwise
};

/// "encodings, …" for messages.
std::string bench_names();
bool is_bench(std::string_view name);

nlohmann::ordered_json bench_encodings_table(const BenchCommand& command, Device& device);
nlohmann::ordered_json bench_light_buffers_table(const BenchCommand& command, Device& device);
nlohmann::ordered_json bench_claims_table(const BenchCommand& command, Device& device);

} // namespace prelight::app
