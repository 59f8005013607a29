#pragma once
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <string>
#include <unistd.h>

namespace prelight::oracle {

inline const std::filesystem::path folder = std::filesystem::path(PRELIGHT_SOURCE_DIR) / "tests/oracle";

/// Whether node and the npm package are there; tests skip visibly when not.
inline bool available(const std::string& package) {
    return std::filesystem::exists(folder / "node_modules" / package) &&
           std::system("node --version > /dev/null 2>&1") == 0;
}
inline std::string missing(const std::string& package) {
    return fmt::format("node or the npm package {} is missing: (cd tests/oracle && npm ci)", package);
}

/// Runs `node tests/oracle/SCRIPT ARGUMENTS…`; true when it exits with 0.
inline bool run(const std::string& script, const std::string& arguments) {
    const auto command = fmt::format("node '{}' {}", (folder / script).string(), arguments);
    return std::system(command.c_str()) == 0;
}

/// A folder of this process's own, gone with the object.
class TemporaryFolder {
public:
    TemporaryFolder() : path(std::filesystem::temp_directory_path() / fmt::format("prelight-test-{}", getpid())) {
        std::filesystem::create_directories(path);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path path;
};

} // namespace prelight::oracle
