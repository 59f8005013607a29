#include <atomic>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <new>
#include <platform/atomic_file.hpp>
#include <platform/program/crash.hpp>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace prelight {
namespace {

// A signal handler reaches nothing but static storage, and calls nothing that allocates or locks.
std::atomic<int> ending = 0; ///< the thread that ends the program
std::atomic<bool> folder_is_set = false;
char folder_to_remove[PATH_MAX];

/// What getdents64() fills; the C library's readdir() allocates.
struct Entry {
    uint64_t inode;
    int64_t next;
    uint16_t length;
    uint8_t type;
    char name[1];
};

void remove_entries(int folder, int depth) noexcept {
    alignas(Entry) char entries[2048];
    for (;;) {
        const long size = syscall(SYS_getdents64, folder, entries, sizeof entries);
        if (size <= 0)
            return;
        for (long at = 0; at < size;) {
            const Entry* entry = reinterpret_cast<const Entry*>(entries + at);
            at += entry->length;
            const char* name = entry->name;
            if (std::strcmp(name, ".") == 0 || std::strcmp(name, "..") == 0)
                continue;
            const int inner = depth > 0 ? openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW) : -1;
            if (inner >= 0) {
                remove_entries(inner, depth - 1);
                close(inner);
            }
            unlinkat(folder, name, inner >= 0 ? AT_REMOVEDIR : 0);
        }
    }
}

void remove_folder() noexcept {
    const int folder = open(folder_to_remove, O_RDONLY | O_DIRECTORY | O_NOFOLLOW);
    if (folder < 0)
        return;
    remove_entries(folder, 1);
    close(folder);
    rmdir(folder_to_remove);
}

/// One write() takes the whole line, so that no other thread's comes between.
struct Line {
    char text[400];
    size_t size = 0;

    void add(const char* word) noexcept {
        for (; *word && size < sizeof text; ++word)
            text[size++] = *word;
    }
    void add(uint64_t number) noexcept {
        char digits[24] = {};
        char* at = digits + 23;
        do
            *--at = static_cast<char>('0' + number % 10);
        while ((number /= 10) != 0);
        add(at);
    }
    void add_limit(int resource, const char* name) noexcept {
        rlimit limit = {};
        if (getrlimit(static_cast<__rlimit_resource>(resource), &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
            return;
        add(", perhaps for want of memory: ");
        add(name);
        add(" is ");
        add(limit.rlim_cur / 1024);
        add(" KiB");
    }
};

const char* name_of(int signal) noexcept {
    switch (signal) {
    case SIGSEGV: return "ended by SIGSEGV (memory that is not there), in the driver or in this program";
    case SIGBUS: return "ended by SIGBUS (memory that is not there), in the driver or in this program";
    case SIGABRT: return "ended by SIGABRT (given up), by the driver or by this program";
    case SIGFPE: return "ended by SIGFPE (arithmetic), in the driver or in this program";
    default: return "ended by SIGILL (an instruction that this processor lacks), in the driver or in this program";
    }
}

extern "C" void on_crash(int signal) { end_by_crash(name_of(signal)); }

[[noreturn]] void on_terminate() {
    if (const std::exception_ptr error = std::current_exception()) {
        try {
            std::rethrow_exception(error);
        } catch (const std::bad_alloc&) {
            end_by_crash("out of memory");
        } catch (...) {
        }
    }
    end_by_crash("ended by an error that nothing caught, in the driver or in this program");
}

} // namespace

void end_by_crash(const char* reason) noexcept {
    int nobody = 0;
    if (!ending.compare_exchange_strong(nobody, gettid())) {
        if (nobody == gettid())
            _exit(1); // a crash in here
        for (;;)
            pause(); // another thread is at it
    }
    Line line;
    line.add("prelight: ");
    line.add(reason);
    line.add_limit(RLIMIT_AS, "ulimit -v");
    line.add_limit(RLIMIT_DATA, "ulimit -d");
    line.add("\n");
    remove_temporary_files();
    if (folder_is_set)
        remove_folder();
    const ssize_t ignored = write(STDERR_FILENO, line.text, line.size);
    static_cast<void>(ignored);
    _exit(1);
}

void handle_crashes() {
    std::set_terminate(on_terminate);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    // A stack of its own: the main thread's may be what has run out. Threads of a driver use theirs.
    alignas(16) static char stack[1 << 16];
    stack_t alternate = {};
    alternate.ss_sp = stack;
    alternate.ss_size = sizeof stack;
    sigaltstack(&alternate, nullptr);
    struct sigaction action = {};
    action.sa_handler = on_crash;
    action.sa_flags = SA_ONSTACK | SA_NODEFER; // a crash within the handler comes to pause() or ends it
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL})
        sigaction(signal, &action, nullptr);
#endif
}

RemovedOnCrash::RemovedOnCrash(const std::filesystem::path& folder) {
    const std::string path = folder.string();
    if (path.size() >= sizeof folder_to_remove)
        return;
    std::memcpy(folder_to_remove, path.c_str(), path.size() + 1);
    folder_is_set = true;
}

RemovedOnCrash::~RemovedOnCrash() { folder_is_set = false; }

} // namespace prelight
