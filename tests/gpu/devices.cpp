#include "devices.hpp"
#include <array>
#include <cstdlib>
#include <filesystem>

namespace prelight {
namespace {

struct Holder : testing::Environment {
    std::array<std::unique_ptr<gpu::Context>, 2> devices;
    void TearDown() override { devices = {}; }
};

} // namespace

void PrintTo(Driver driver, std::ostream* out) { *out << (driver == Driver::lavapipe ? "lavapipe" : "swiftshader"); }

std::string driver_name(const testing::TestParamInfo<Driver>& info) { return testing::PrintToString(info.param); }

bool swiftshader_installed() { return std::filesystem::exists(swiftshader_driver_file); }

bool newer_layer_installed() {
    return std::filesystem::exists(PRELIGHT_BUILD_DIR "/share/prelight/layers/VkLayer_khronos_validation.json") &&
           std::getenv("VK_LAYER_PATH") == std::string(PRELIGHT_BUILD_DIR "/share/prelight/layers");
}

std::unique_ptr<gpu::Context> make_device(Driver driver) {
    if (driver == Driver::lavapipe)
        return std::make_unique<gpu::Context>(DeviceOptions{.select = "cpu", .validate = true});
    const ScopedVariable only("VK_DRIVER_FILES", swiftshader_driver_file);
    return std::make_unique<gpu::Context>(DeviceOptions{.select = "auto", .validate = true});
}

gpu::Context& shared_device(Driver driver) {
    static auto* holder = static_cast<Holder*>(testing::AddGlobalTestEnvironment(new Holder));
    auto& device = holder->devices[static_cast<size_t>(driver)];
    if (!device)
        device = make_device(driver);
    return *device;
}

void OnDevice::SetUp() {
    if (driver_ == Driver::swiftshader && !swiftshader_installed())
        GTEST_SKIP() << "SwiftShader is not installed (Debian's package chromium has it)";
    seen_ = context().validation_messages().size();
}

void OnDevice::TearDown() {
    if (IsSkipped())
        return;
    const std::vector<std::string> messages = context().validation_messages();
    for (size_t i = seen_; i < messages.size(); ++i)
        ADD_FAILURE() << "validation: " << messages[i];
}

ScopedVariable::ScopedVariable(std::string name, const char* value) : name_(std::move(name)) {
    if (const char* before = std::getenv(name_.c_str())) {
        before_ = before;
        was_set_ = true;
    }
    if (value)
        setenv(name_.c_str(), value, 1);
    else
        unsetenv(name_.c_str());
}

ScopedVariable::~ScopedVariable() {
    if (was_set_)
        setenv(name_.c_str(), before_.c_str(), 1);
    else
        unsetenv(name_.c_str());
}

} // namespace prelight
