#include "kept_steps.hpp"

#include <fmt/format.h>
#include <fstream>
#include <gpu/cache_file.hpp>
#include <platform/process.hpp>

namespace prelight::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr size_t most_reports = 8; ///< that were left unfinished

void write(const fs::path& file, const std::string& text) { gpu::write_cache(file, std::as_bytes(std::span(text))); }

std::string read(const fs::path& file) {
    const std::vector<std::byte> bytes = gpu::read_cache(file);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

} // namespace

KeptSteps::KeptSteps(std::string key) {
    state_ = {{"key", key}, {"steps", Json::object()}};
    const fs::path cache = gpu::cache_folder();
    if (cache.empty())
        return;
    gpu::CacheKey hash;
    hash.add(key);
    folder_ = cache / "compare" / hash.text();
    Json before = Json::parse(read(folder_ / "steps"), nullptr, false);
    if (before.is_object() && before.contains("key") && before["key"] == key && before.contains("steps") &&
        before["steps"].is_object())
        state_ = std::move(before);
    found_ = state_["steps"].size() - state_["steps"].count("pictures"); // which is of all steps
}

const Json* KeptSteps::find(const std::string& step) const {
    const auto found = state_["steps"].find(step);
    return found == state_["steps"].end() ? nullptr : &*found;
}

void KeptSteps::keep(const std::string& step, Json result) {
    state_["steps"][step] = std::move(result);
    if (folder_.empty())
        return;
    write(folder_ / "steps", state_.dump(-1, ' ', false, Json::error_handler_t::replace));
    gpu::trim_cache(folder_.parent_path(), most_reports);
}

std::optional<std::string> KeptSteps::find_file(const std::string& name) const {
    std::string bytes = folder_.empty() ? "" : read(folder_ / name);
    return bytes.empty() ? std::nullopt : std::optional(std::move(bytes));
}

void KeptSteps::keep_file(const std::string& name, const fs::path& file) {
    if (folder_.empty())
        return;
    std::ifstream stream(file, std::ios::binary);
    write(folder_ / name, std::string(std::istreambuf_iterator<char>(stream), {}));
}

void KeptSteps::forget() {
    std::error_code ignored;
    state_["steps"] = Json::object();
    found_ = 0;
    if (!folder_.empty())
        fs::remove_all(folder_, ignored);
}

std::string content_key(const fs::path& file) {
    std::error_code error;
    std::ifstream stream;
    if (fs::is_regular_file(file, error))
        stream.open(file, std::ios::binary);
    if (!stream.is_open())
        return fmt::format("{}: none\n", file.string());
    gpu::CacheKey hash;
    std::vector<char> buffer(1 << 20);
    while (stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size())) || stream.gcount() > 0)
        hash.add({buffer.data(), static_cast<size_t>(stream.gcount())});
    return fmt::format("{}: {}\n", file.string(), hash.text());
}

std::string program_key() { return program_identity() + "\n"; }

} // namespace prelight::app
