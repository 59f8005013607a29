#pragma once
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace prelight {

/// An empty folder for one test, removed at the end.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "prelight-test-XXXXXX").string();
        if (!mkdtemp(name.data()))
            ADD_FAILURE() << "no temporary folder";
        path = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    size_t entries() const {
        size_t count = 0;
        for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path))
            ++count;
        return count;
    }
    std::filesystem::path path;
};

} // namespace prelight
