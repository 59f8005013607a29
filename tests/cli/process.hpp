#pragma once
#include <filesystem>
#include <functional>
#include <image/temporary_folder.hpp>
#include <map>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace prelight::test {

/// How a run of the program ended.
struct Result {
    int status = -1;        ///< exit status; −1 when a signal ended it
    int signal = 0;         ///< that signal
    bool timed_out = false; ///< the test ended it
    double seconds = 0;
    uint64_t peak_bytes = 0; ///< resident memory at its highest
    std::string out, err;
};

struct Limits {
    double seconds = 60;        ///< after these it is killed; generous: machines differ
    uint64_t address_space = 0; ///< bytes, RLIMIT_AS; 0: none
};

/// The program as a process of its own, in its own working folder.
class Prelight {
public:
    /// Starts `prelight ARGUMENTS…` in `folder`, with stdout and stderr going to files outside it.
    Prelight(std::vector<std::string> arguments, const std::filesystem::path& folder,
             const std::map<std::string, std::string>& environment = {}, Limits limits = {});
    ~Prelight();
    Prelight(const Prelight&) = delete;
    Prelight& operator=(const Prelight&) = delete;

    void send(int signal) const;
    bool running();
    Result wait();

private:
    bool poll(bool block);

    pid_t pid_ = -1;
    Limits limits_;
    double started_ = 0;
    std::optional<Result> result_;
    TemporaryFolder streams_;
};

/// Runs it to the end.
Result run(std::vector<std::string> arguments, const std::filesystem::path& folder, Limits limits = {},
           const std::map<std::string, std::string>& environment = {});

/// `arguments`, then `more`.
std::vector<std::string> joined(std::vector<std::string> arguments, const std::vector<std::string>& more);

/// Waits until `condition` holds; false after 60 s.
bool eventually(const std::function<bool()>& condition);

/// Success: exit status 0 and nothing on stderr but warnings.
testing::AssertionResult succeeded(const Result& result);
/// Exit status `status` and exactly one line on stderr (beside warnings), "prelight: …".
testing::AssertionResult failed_with(const Result& result, int status);

/// True in a build with AddressSanitizer, which needs terabytes of address space.
constexpr bool address_sanitizer =
#ifdef __SANITIZE_ADDRESS__
    true;
#else
    false;
#endif

} // namespace prelight::test
