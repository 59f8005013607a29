#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <platform/program/child_process.hpp>
#include <platform/program/watchdog.hpp>
#include <prelight/error.hpp>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace prelight {
namespace {

constexpr int output_in_child = 3;
constexpr size_t longest_message = 65536;

/// A descriptor above those that the child is given: duplicated there, it would be closed under another's name.
int above_standard(int descriptor) {
    if (descriptor < 0)
        return descriptor;
    const int moved = fcntl(descriptor, F_DUPFD_CLOEXEC, output_in_child + 1);
    close(descriptor);
    return moved;
}

/// What of its own the child does not take over: its signals are as in any program.
struct SpawnAttributes {
    posix_spawnattr_t value;
    SpawnAttributes() {
        posix_spawnattr_init(&value);
        sigset_t all, none;
        sigfillset(&all);
        sigemptyset(&none);
        posix_spawnattr_setsigdefault(&value, &all);
        posix_spawnattr_setsigmask(&value, &none);
        posix_spawnattr_setpgroup(&value, 0);
        posix_spawnattr_setflags(&value, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    }
    ~SpawnAttributes() { posix_spawnattr_destroy(&value); }
};

struct SpawnActions {
    posix_spawn_file_actions_t value;
    SpawnActions(int input, int output, int messages) {
        posix_spawn_file_actions_init(&value);
        posix_spawn_file_actions_adddup2(&value, input, STDIN_FILENO);
        posix_spawn_file_actions_addopen(&value, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
        posix_spawn_file_actions_adddup2(&value, messages, STDERR_FILENO);
        posix_spawn_file_actions_adddup2(&value, output, output_in_child);
    }
    ~SpawnActions() { posix_spawn_file_actions_destroy(&value); }
};

} // namespace

const char* const ChildProcess::output_name = "/proc/self/fd/3"; // output_in_child

ChildProcess::ChildProcess(std::vector<std::string> arguments, const std::filesystem::path& output)
    : name_(arguments.at(0)) {
    std::vector<char*> argv;
    for (std::string& argument : arguments)
        argv.push_back(argument.data());
    argv.push_back(nullptr);
    int ends[2] = {-1, -1};
    if (pipe2(ends, O_CLOEXEC) != 0)
        throw Error(fmt::format("{}: no pipe ({})", name_, std::strerror(errno)));
    const int reads = above_standard(ends[0]);
    input_ = above_standard(ends[1]);
    messages_ = above_standard(memfd_create("messages", MFD_CLOEXEC));
    const int file = above_standard(open(output.c_str(), O_RDWR | O_CLOEXEC));
    int error = errno;
    if (reads >= 0 && input_ >= 0 && messages_ >= 0 && file >= 0) {
        const SpawnAttributes attributes;
        const SpawnActions actions(reads, file, messages_);
        error = posix_spawnp(&pid_, name_.c_str(), &actions.value, &attributes.value, argv.data(), environ);
    }
    for (const int descriptor : {reads, file})
        close(descriptor);
    if (error == 0)
        return;
    close(input_);
    close(messages_);
    throw Error(error == ENOENT ? fmt::format("{}: is not on the PATH", name_)
                                : fmt::format("{}: cannot be started ({})", name_, std::strerror(error)));
}

ChildProcess::~ChildProcess() {
    if (pid_ > 0)
        kill(pid_, SIGKILL);
    wait();
    close(messages_);
}

void ChildProcess::write(std::span<const uint8_t> bytes) {
    const WatchdogPause pause; // it takes its time
    while (!bytes.empty()) {
        const ssize_t done = ::write(input_, bytes.data(), bytes.size());
        if (done < 0 && errno == EINTR)
            continue;
        if (done < 0) { // its end of the pipe is closed
            wait();
            fail();
        }
        bytes = bytes.subspan(static_cast<size_t>(done));
    }
}

void ChildProcess::wait() {
    if (input_ >= 0)
        close(input_);
    input_ = -1;
    const WatchdogPause pause;
    while (pid_ > 0 && waitpid(pid_, &status_, 0) < 0 && errno == EINTR)
        continue;
    pid_ = -1;
}

void ChildProcess::finish() {
    wait();
    if (status_ != 0)
        fail();
}

void ChildProcess::fail() const {
    const std::string end = WIFSIGNALED(status_) ? fmt::format("was ended by signal {}", WTERMSIG(status_))
                                                 : fmt::format("ended with status {}", WEXITSTATUS(status_));
    const std::string message = last_message();
    throw Error(fmt::format("{}: {}{}", name_, end, message.empty() ? "" : fmt::format(" ({})", message)));
}

std::string ChildProcess::last_message() const {
    const off_t size = lseek(messages_, 0, SEEK_END);
    std::string text(std::min<size_t>(static_cast<size_t>(std::max<off_t>(size, 0)), longest_message), '\0');
    const ssize_t read = pread(messages_, text.data(), text.size(), size - static_cast<off_t>(text.size()));
    text.resize(static_cast<size_t>(std::max<ssize_t>(read, 0)));
    while (text.ends_with('\n'))
        text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

} // namespace prelight
