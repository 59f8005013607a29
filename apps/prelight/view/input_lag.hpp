#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>

namespace prelight::app::viewer {

/// Counts the pictures that come onto the screen from input to the first one that shows what it did, that one included.
class InputLag {
public:
    /// Input has been found, of which it is known only that it is newer than the look() before.
    void take(uint32_t step) {
        if (!waits_)
            waits_ = Waiting{step, looked_at_};
    }
    /// Somebody has looked for input, found or not.
    void look() { looked_at_ = pictures_; }
    /// A picture of a session that has gone so many steps is on the screen.
    void show(uint32_t steps) {
        ++pictures_;
        if (!waits_ || steps <= waits_->step) // what it does, it does in a step
            return;
        most_ = std::max(most_, pictures_ - waits_->pictures);
        waits_.reset();
        ++measured_;
    }
    /// Nothing has changed after so many steps: input that had no effect is in no picture.
    void rest(uint32_t steps) {
        if (waits_ && steps > waits_->step)
            waits_.reset();
    }
    uint32_t pictures() const { return pictures_; }
    /// How often input was found in a picture, and the largest number of pictures that this took.
    uint32_t measured() const { return measured_; }
    uint32_t most() const { return most_; }

private:
    struct Waiting {
        uint32_t step, pictures;
    };
    std::optional<Waiting> waits_; ///< the oldest input that no picture has shown
    uint32_t pictures_ = 0, looked_at_ = 0, measured_ = 0, most_ = 0;
};

} // namespace prelight::app::viewer
