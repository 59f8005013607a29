#pragma once
#include "session.hpp"

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace prelight::app {

/// A frame that has been drawn: its pictures with the files that receive them.
struct DrawnFrame {
    uint32_t number = 0;
    std::vector<Picture> pictures;
};

/// Encodes and writes frames in threads of its own while the next ones are drawn. With one thread in the order in
/// which they come.
class FrameWriter {
public:
    using Write = std::function<void(const DrawnFrame&)>;
    /// `write` is called in the threads, for each frame once.
    FrameWriter(unsigned threads, Write write);
    /// Frames that no thread has begun with are dropped.
    ~FrameWriter();
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    /// Waits while as many frames wait as there are threads: what is drawn fills no memory. Throws what `write` threw.
    void push(DrawnFrame frame);
    /// Waits until all have been written. Throws what `write` threw.
    void finish();

private:
    void work();
    void check() const; ///< throws failure_

    const Write write_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<DrawnFrame> waiting_;
    unsigned writing_ = 0;
    bool over_ = false;
    std::exception_ptr failure_;
    std::vector<std::thread> threads_;
};

} // namespace prelight::app
