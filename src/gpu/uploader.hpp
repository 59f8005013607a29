#pragma once
#include "buffer.hpp"
#include "command_slot.hpp"
#include "frames_in_flight.hpp"

namespace prelight::gpu {

/// Copies many things to the device with few submissions: the host fills one block of staging memory
/// while the device copies from the other.
class Uploader {
public:
    explicit Uploader(const Context& context) : context_(context) {}
    ~Uploader();
    Uploader(const Uploader&) = delete;
    Uploader& operator=(const Uploader&) = delete;

    /// Memory for the host to fill before anything else is called here, and where the device finds it.
    struct Staging {
        std::byte* bytes = nullptr;
        VkBuffer buffer = VK_NULL_HANDLE;
        uint64_t offset = 0; ///< a multiple of 16
    };
    Staging stage(uint64_t size);
    /// Where the copy from the last stage() is recorded.
    VkCommandBuffer commands() const { return blocks_[current_].recorded.commands; }
    /// Submits what is recorded and waits for all of it. Throws Error.
    void finish();

private:
    struct Block {
        Buffer buffer;
        uint64_t used = 0;
        CommandSlot recorded;
        uint64_t submitted = 0; ///< value of the timeline; 0: not in flight
    };
    void begin(uint64_t size);
    void submit();

    const Context& context_;
    PerFrame<Block> blocks_;
    uint32_t current_ = 0;
    bool recording_ = false;
};

} // namespace prelight::gpu
