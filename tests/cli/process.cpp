#include "process.hpp"

#include "files.hpp"
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>

namespace prelight::test {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Only what is safe between fork and exec.
[[noreturn]] void become(const std::vector<char*>& arguments, const std::vector<char*>& environment, const char* folder,
                         const char* out, const char* err, uint64_t address_space) {
    const int out_file = open(out, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err_file = open(err, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (out_file < 0 || err_file < 0 || dup2(out_file, 1) < 0 || dup2(err_file, 2) < 0 || chdir(folder) != 0)
        _exit(126);
    if (address_space != 0) {
        const rlimit limit = {address_space, address_space};
        setrlimit(RLIMIT_AS, &limit);
    }
    const rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    for (const int signal : {SIGINT, SIGHUP, SIGQUIT})
        std::signal(signal, SIG_DFL); // a shell's background jobs and nohup's children ignore some of them
    execve(arguments[0], arguments.data(), environment.data());
    _exit(127);
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> result;
    for (std::string& text : texts)
        result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

/// Our own environment, with `changes`, and with caches that are not the user's.
std::vector<std::string> make_variables(std::map<std::string, std::string> changes) {
    const std::string build = PRELIGHT_BUILD_DIR;
    if (!std::getenv("MESA_SHADER_CACHE_DIR"))
        changes.emplace("MESA_SHADER_CACHE_DIR", build + "/../shader-cache");
    if (!std::getenv("XDG_CACHE_HOME"))
        changes.emplace("XDG_CACHE_HOME", build + "/../test-cache");
    std::vector<std::string> result;
    for (char** entry = environ; *entry; ++entry) {
        const std::string text = *entry;
        if (!changes.contains(text.substr(0, text.find('='))))
            result.push_back(text);
    }
    for (const auto& [name, value] : changes)
        result.push_back(name + "=" + value);
    return result;
}

/// The lines of stderr that are neither warnings of the loader nor a long command's progress.
std::vector<std::string> complaints(const std::string& err) {
    std::vector<std::string> lines;
    std::istringstream stream(err);
    for (std::string line; std::getline(stream, line);)
        if (line.rfind("warning: ", 0) != 0 && line.rfind("[", 0) != 0)
            lines.push_back(line);
    return lines;
}

} // namespace

Prelight::Prelight(std::vector<std::string> arguments, const std::filesystem::path& folder,
                   const std::map<std::string, std::string>& environment, Limits limits)
    : limits_(limits), started_(now()) {
    arguments.insert(arguments.begin(), PRELIGHT_PROGRAM);
    std::vector<std::string> variables = make_variables(environment);
    const std::vector<char*> argv = pointers(arguments), envp = pointers(variables);
    const std::string out = streams_.path / "out", err = streams_.path / "err";
    pid_ = fork();
    if (pid_ == 0)
        become(argv, envp, folder.c_str(), out.c_str(), err.c_str(), limits.address_space);
    if (pid_ < 0)
        ADD_FAILURE() << "cannot start a process";
}

Prelight::~Prelight() {
    if (pid_ > 0 && !result_) {
        kill(pid_, SIGKILL);
        poll(true);
    }
}

void Prelight::send(int signal) const {
    if (pid_ > 0 && !result_)
        kill(pid_, signal);
}

bool Prelight::poll(bool block) {
    if (result_)
        return true;
    int status = 0;
    rusage usage = {};
    if (wait4(pid_, &status, block ? 0 : WNOHANG, &usage) != pid_)
        return false;
    result_.emplace();
    result_->status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    result_->signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    result_->seconds = now() - started_;
    result_->peak_bytes = static_cast<uint64_t>(usage.ru_maxrss) * 1024;
    result_->out = bytes_of(streams_.path / "out");
    result_->err = bytes_of(streams_.path / "err");
    return true;
}

bool Prelight::running() { return !poll(false); }

Result Prelight::wait() {
    while (!poll(false)) {
        if (now() - started_ > limits_.seconds) {
            kill(pid_, SIGKILL);
            poll(true);
            result_->timed_out = true;
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return *result_;
}

Result run(std::vector<std::string> arguments, const std::filesystem::path& folder, Limits limits,
           const std::map<std::string, std::string>& environment) {
    return Prelight(std::move(arguments), folder, environment, limits).wait();
}

std::vector<std::string> joined(std::vector<std::string> arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

bool eventually(const std::function<bool()>& condition) {
    for (const double end = now() + 60; now() < end; std::this_thread::sleep_for(std::chrono::milliseconds(5)))
        if (condition())
            return true;
    return false;
}

testing::AssertionResult succeeded(const Result& result) {
    if (!result.timed_out && result.status == 0 && complaints(result.err).empty())
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << (result.timed_out ? "timed out; " : "") << "status " << result.status
                                       << ", signal " << result.signal << ", stderr: " << result.err;
}

testing::AssertionResult failed_with(const Result& result, int status) {
    const std::vector<std::string> lines = complaints(result.err);
    if (!result.timed_out && result.status == status && lines.size() == 1 && lines[0].rfind("prelight: ", 0) == 0 &&
        lines[0].size() > 12 && result.err.back() == '\n')
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << (result.timed_out ? "timed out; " : "") << "expected status " << status
                                       << " and one line, got status " << result.status << ", signal " << result.signal
                                       << ", stderr: " << result.err;
}

} // namespace prelight::test
