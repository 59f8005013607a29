// Too little memory, signals and standstill: a line and status 1, in bounded time.
#include "process.hpp"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <gmock/gmock.h>
#include <memory_check.hpp>
#include <platform/atomic_file.hpp>
#include <platform/program/crash.hpp>
#include <platform/program/watchdog.hpp>
#include <platform/spare_memory.hpp>
#include <prelight/error.hpp>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

namespace prelight::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// A driver may fail anywhere between the last limit that is refused at once and the first that is enough.
TEST(TooLittleMemory, IsAnErrorAndNeverASignal) {
    if (address_sanitizer)
        GTEST_SKIP() << "AddressSanitizer wants terabytes of address space";
    for (const uint64_t kibibytes : {200'000, 340'000, 400'000, 450'000, 480'000, 520'000}) {
        SCOPED_TRACE(kibibytes);
        const TemporaryFolder folder;
        const Result result = run({"render", "spheres", "--lights", "2", "--size", "64x36", "-o", "a.png"}, folder.path,
                                  {.seconds = 180, .address_space = kibibytes * 1024}, {{"PRELIGHT_STANDSTILL", "20"}});
        EXPECT_FALSE(result.timed_out);
        EXPECT_EQ(result.signal, 0);
        EXPECT_TRUE(result.status == 0 || result.status == 1) << result.status;
        EXPECT_EQ(folder.entries(), result.status == 0 ? 1u : 0u);
        EXPECT_EQ(result.err.find("prelight: ") != std::string::npos, result.status == 1);
    }
}

TEST(TooLittleMemory, IsToldBeforeTheDriverIsAsked) {
    if (address_sanitizer)
        GTEST_SKIP() << "AddressSanitizer wants terabytes of address space";
    const TemporaryFolder folder;
    const Result result = run({"render", "spheres", "--size", "1280x720", "-o", "a.png"}, folder.path,
                              {.address_space = uint64_t(400) << 20});
    EXPECT_TRUE(failed_with(result, 1));
    EXPECT_THAT(result.err, HasSubstr("a frame of 1280x720 needs about"));
    EXPECT_THAT(result.err, HasSubstr("of address space, ulimit -v leaves"));
    EXPECT_LT(result.seconds, 30);
}

TEST(TooLittleMemory, EveryLimitThatThereIsIsAsked) {
    const std::vector<MemoryRoom> rooms = memory_rooms();
    EXPECT_THAT(rooms, testing::Contains(testing::Field(&MemoryRoom::limit, "this machine")));
    for (const MemoryRoom& room : rooms)
        EXPECT_GT(room.bytes, 0u) << room.limit;
    EXPECT_THROW(app::check_memory("everything", uint64_t(1) << 60, uint64_t(1) << 60), Error);
    app::check_memory("nothing", 1, 1);
}

void prepare() {
    const rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    handle_crashes();
}

/// `end` runs in a process of its own, with a temporary file and a folder that it must not leave.
void expect_last_words(const std::function<void()>& end, const char* words) {
    if (address_sanitizer)
        GTEST_SKIP() << "signals are the sanitizer's";
    const TemporaryFolder folder;
    const auto run = [&] {
        prepare();
        AtomicFile file(folder.path / "a.png");
        fs::create_directories(folder.path / "growing/pictures");
        std::ofstream(folder.path / "growing/pictures/b.png") << "b";
        std::ofstream(folder.path / "growing/index.html") << "page";
        const RemovedOnCrash removed(folder.path / "growing");
        end();
    };
    EXPECT_EXIT(run(), testing::ExitedWithCode(1), words);
    EXPECT_EQ(folder.entries(), 0u);
}

int depth(volatile int* below) {
    volatile int here[256] = {};
    here[0] = *below + 1;
    return *below < 0 ? 0 : depth(here) + here[0]; // never below 0: it goes on until the stack ends
}

TEST(LastWords, OfEverySignal) {
    GTEST_FLAG_SET(death_test_style, "fast");
    for (const auto& [signal, words] : {std::pair(SIGSEGV, "^prelight: ended by SIGSEGV"),
                                        {SIGBUS, "^prelight: ended by SIGBUS"},
                                        {SIGABRT, "^prelight: ended by SIGABRT"},
                                        {SIGFPE, "^prelight: ended by SIGFPE"},
                                        {SIGILL, "^prelight: ended by SIGILL"}})
        expect_last_words([signal = signal] { std::raise(signal); }, words);
}

TEST(LastWords, OfAFullStackAndOfAnotherThread) {
    volatile int bottom = 0;
    expect_last_words([&] { depth(&bottom); }, "^prelight: ended by SIGSEGV");
    expect_last_words([] { std::thread([] { std::abort(); }).join(); }, "^prelight: ended by SIGABRT");
}

TEST(LastWords, OfAnExceptionThatNothingCatches) {
    expect_last_words([] { std::thread([] { throw std::bad_alloc(); }).join(); }, "^prelight: out of memory");
    expect_last_words([] { std::thread([] { throw 1; }).join(); }, "^prelight: ended by an error that nothing caught");
}

TEST(LastWords, OfARunThatStandsStill) {
    expect_last_words(
        [] {
            start_watchdog(2);
            std::this_thread::sleep_for(std::chrono::seconds(60));
        },
        "^prelight: stands still");
}

TEST(LastWords, NoneOfARunThatWorksOrMeansToWait) {
    const auto work = [] {
        prepare();
        start_watchdog(2);
        {
            const WatchdogPause pause;
            std::this_thread::sleep_for(std::chrono::seconds(4));
        }
        volatile uint64_t sum = 0;
        for (const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(4);
             std::chrono::steady_clock::now() < end;)
            sum = sum + 1;
        std::_Exit(7);
    };
    EXPECT_EXIT(work(), testing::ExitedWithCode(7), "");
}

} // namespace
} // namespace prelight::test
