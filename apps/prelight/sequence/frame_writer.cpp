#include "sequence/frame_writer.hpp"

#include <platform/program/interrupt.hpp>

namespace prelight::app {

FrameWriter::FrameWriter(unsigned threads, Write write) : write_(std::move(write)) {
    for (unsigned i = 0; i < threads; ++i)
        threads_.emplace_back([this] { work(); });
}

FrameWriter::~FrameWriter() {
    {
        const std::lock_guard lock(mutex_);
        over_ = true;
        waiting_.clear();
    }
    changed_.notify_all();
    for (std::thread& thread : threads_)
        thread.join();
}

void FrameWriter::check() const {
    if (failure_)
        std::rethrow_exception(failure_);
}

void FrameWriter::push(DrawnFrame frame) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return failure_ || waiting_.size() < threads_.size(); });
    check();
    waiting_.push_back(std::move(frame));
    lock.unlock();
    changed_.notify_all();
}

void FrameWriter::finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return failure_ || (waiting_.empty() && writing_ == 0); });
    check();
}

void FrameWriter::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return over_ || failure_ || !waiting_.empty(); });
        // An interrupt waits for writers to end; with a new file begun each time that might be never.
        if (over_ || failure_ || is_interrupted())
            return;
        const DrawnFrame frame = std::move(waiting_.front());
        waiting_.pop_front();
        ++writing_;
        lock.unlock();
        changed_.notify_all(); // there is room
        std::exception_ptr failure;
        try {
            write_(frame);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        --writing_;
        if (failure && !failure_)
            failure_ = failure;
        changed_.notify_all();
    }
}

} // namespace prelight::app
