#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace prelight {

/// Another program that reads what this one gives it, found on the PATH and started without a shell. A group of its
/// own: Ctrl-C reaches this program only, whose end closes the pipe.
class ChildProcess {
public:
    /// Under which name the program finds its output.
    static const char* const output_name;

    /// `output`: a file that the program finds as `output_name`, for reading and writing. Its standard output is lost,
    /// its messages are kept. Throws Error: there is no such program, or it cannot be started.
    ChildProcess(std::vector<std::string> arguments, const std::filesystem::path& output);
    /// Ends it when it still runs.
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// To its standard input; waits for it to read. Throws Error as finish() when it has gone.
    void write(std::span<const uint8_t> bytes);
    /// Ends its input and waits for it. Throws Error with its exit status and the last line of its messages unless that
    /// is 0.
    void finish();

private:
    void wait();
    [[noreturn]] void fail() const;
    std::string last_message() const;

    std::string name_;
    int pid_ = -1;
    int input_ = -1;    ///< our end of the pipe
    int messages_ = -1; ///< a file without a name
    int status_ = 0;    ///< as waitpid() gives it
};

} // namespace prelight
