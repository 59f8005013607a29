#include "output.hpp"

#include <platform/program/file_identity.hpp>
#include <platform/program/standard_streams.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <platform/atomic_file.hpp>
#include <prelight/error.hpp>

namespace prelight::app {

namespace fs = std::filesystem;

void check_writable(const fs::path& path) {
    if (is_standard_stream(path))
        return;
    const WriteGuard guard;
    const AtomicFile probe(path); // never committed, so it goes again
}

void check_distinct(std::span<const fs::path> outputs, std::span<const fs::path> inputs) {
    std::map<FileIdentity, const fs::path*> written; // a sequence has thousands
    for (const fs::path& output : outputs) {
        const std::optional<FileIdentity> identity = output.empty() ? std::nullopt : identity_of(output);
        if (!identity)
            continue;
        const auto [same, is_new] = written.emplace(*identity, &output);
        if (!is_new)
            throw UsageError(*same->second == output ? fmt::format("{}: named for two outputs", output.string())
                                                     : fmt::format("{}: is the same file as {}: named for two outputs",
                                                                   output.string(), same->second->string()));
    }
    for (const fs::path& input : inputs) {
        const std::optional<FileIdentity> identity = input.empty() ? std::nullopt : identity_of(input);
        const auto same = identity && identity->name.empty() ? written.find(*identity) : written.end();
        if (same == written.end())
            continue;
        const fs::path& name = *same->second;
        throw UsageError(name == input ? fmt::format("{}: is read by this run and cannot be its output", name.string())
                                       : fmt::format("{}: is the same file as {}, which this run reads", name.string(),
                                                     input.string()));
    }
}

void check_outside(const fs::path& folder, std::span<const fs::path> inputs) {
    std::error_code error;
    const fs::path place = fs::weakly_canonical(folder, error);
    for (const fs::path& input : inputs) {
        const fs::path file = input.empty() || error ? fs::path() : fs::weakly_canonical(input, error);
        const auto [rest, ignored] = std::mismatch(place.begin(), place.end(), file.begin(), file.end());
        if (!file.empty() && rest == place.end())
            throw UsageError(fmt::format("{}: holds {}, which this run reads", folder.string(), input.string()));
    }
}

void save_text(std::string_view text, const fs::path& path) {
    if (is_standard_stream(path))
        return write_standard_output(std::as_bytes(std::span(text)));
    const WriteGuard guard;
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

} // namespace prelight::app
