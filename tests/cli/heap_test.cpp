// The program's heap lies in huge pages where the system gives them to who asks.
#include "process.hpp"

#include <fstream>
#include <gmock/gmock.h>
#include <sys/resource.h>

namespace prelight::test {
namespace {

/// Page faults of one run, and whether it ended well.
long faults_of(bool limited) {
    const TemporaryFolder folder;
    const auto now = [] {
        rusage usage{};
        getrusage(RUSAGE_CHILDREN, &usage);
        return usage.ru_minflt;
    };
    const long before = now();
    const Result result = run({"make", "city", "-o", "a.glb"}, folder.path,
                              {.address_space = limited ? uint64_t(64) << 30 : uint64_t(0)});
    EXPECT_TRUE(succeeded(result));
    return now() - before;
}

TEST(Heap, LiesInHugePages) {
    std::string mode;
    std::getline(std::ifstream("/sys/kernel/mm/transparent_hugepage/enabled"), mode);
    if (mode.find("[madvise]") == std::string::npos)
        GTEST_SKIP() << "this system gives huge pages to everybody or nobody: " << mode;
    if (address_sanitizer)
        GTEST_SKIP() << "AddressSanitizer has a heap of its own";
    const long asked = faults_of(false), not_asked = faults_of(true); // a limit of address space: nothing is reserved
    EXPECT_LT(2 * asked, not_asked);
}

} // namespace
} // namespace prelight::test
