#pragma once
#include <gpu/context.hpp>
#include <gtest/gtest.h>
#include <memory>
#include <prelight/error.hpp>
#include <string>

namespace prelight {

/// The software drivers that the tests run on.
enum class Driver { lavapipe, swiftshader };
void PrintTo(Driver driver, std::ostream* out);

/// SwiftShader's driver file comes with Debian's chromium package.
inline constexpr const char* swiftshader_driver_file = "/usr/lib/chromium/vk_swiftshader_icd.json";
bool swiftshader_installed();
/// The newer validation layer (chromium-common), which sees hazards in dynamic rendering, is in use.
bool newer_layer_installed();

/// A device of the caller's own, with core and synchronization validation.
std::unique_ptr<gpu::Context> make_device(Driver driver = Driver::lavapipe);
/// The device that the tests of this process share: made at its first use, gone before exit, because
/// the validation layer's own statics must still be there.
gpu::Context& shared_device(Driver driver = Driver::lavapipe);

/// A test on the shared lavapipe device. A validation message that came during it fails it.
class OnDevice : public testing::Test {
protected:
    explicit OnDevice(Driver driver = Driver::lavapipe) : driver_(driver) {}
    void SetUp() override;
    void TearDown() override;
    gpu::Context& context() { return shared_device(driver_); }

private:
    Driver driver_;
    size_t seen_ = 0;
};

/// The same on both drivers; skipped, saying so, where SwiftShader is not installed.
class OnEachDevice : public OnDevice, public testing::WithParamInterface<Driver> {
protected:
    OnEachDevice() : OnDevice(GetParam()) {}
};
std::string driver_name(const testing::TestParamInfo<Driver>& info);

/// Sets an environment variable (unsets it when `value` is null) until the end of the scope.
class ScopedVariable {
public:
    ScopedVariable(std::string name, const char* value);
    ~ScopedVariable();
    ScopedVariable(const ScopedVariable&) = delete;
    ScopedVariable& operator=(const ScopedVariable&) = delete;

private:
    std::string name_, before_;
    bool was_set_ = false;
};

} // namespace prelight
