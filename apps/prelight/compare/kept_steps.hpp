#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace prelight::app {

/// The finished steps of a `compare` that did not come to its end, for the next run with the same key: in
/// the cache folder, each file with a checksum. Nothing of it is needed: what cannot be kept or is damaged is
/// done again.
class KeptSteps {
public:
    /// `key`: all that decides what the steps come to.
    explicit KeptSteps(std::string key);

    /// What keep() was given under this name, by this process or one before it.
    const nlohmann::json* find(const std::string& step) const;
    size_t found() const { return found_; } ///< steps of a process before
    void keep(const std::string& step, nlohmann::json result);

    /// The bytes of a file, by a name without folders.
    std::optional<std::string> find_file(const std::string& name) const;
    void keep_file(const std::string& name, const std::filesystem::path& file);

    /// Removes all of it: the command has come to its end.
    void forget();

private:
    std::filesystem::path folder_; ///< empty: nothing is kept
    nlohmann::json state_;
    size_t found_ = 0;
};

/// A key's part for a file: its content, or that it is not there.
std::string content_key(const std::filesystem::path& file);
/// The program itself, as it was built.
std::string program_key();

} // namespace prelight::app
