#include "trim_draws.hpp"
#include <algorithm>
#include <atomic>
#include <cstring>
#include <memory>
#include <parallel/parallel_for.hpp>
#include <platform/clocks.hpp>
#include <thread>

namespace prelight::resident {
namespace {

/// Indices that one thread takes at a time; fewer altogether are not worth a thread, which takes 50 µs to start.
constexpr size_t chunk_indices = 3u << 16;

/// What faces the viewer has its vertices elsewhere.
bool is_trimmed(const Draw& draw) { return draw.primitive && !draw.facing(); }

/// Draws that one thread takes at a time.
struct Chunk {
    size_t first = 0, count = 0;
    size_t indices = 0; ///< of those that are to be trimmed
};

std::vector<Chunk> chunks_of(std::span<const VisibleDraw> draws, std::span<const Draw> all, size_t room) {
    std::vector<Chunk> chunks;
    for (size_t d = 0; d < draws.size(); ++d) {
        if (chunks.empty() || chunks.back().indices >= chunk_indices)
            chunks.push_back({.first = d});
        ++chunks.back().count;
        if (is_trimmed(all[draws[d].draw]) && draws[d].index_count <= room)
            chunks.back().indices += draws[d].index_count;
    }
    return chunks;
}

/// Chunks find their places in turn, also after one that failed.
class InTurn {
public:
    InTurn(std::atomic<uint32_t>& turn, uint32_t number) : turn_(turn), number_(number) {}
    InTurn(const InTurn&) = delete;
    InTurn& operator=(const InTurn&) = delete;
    ~InTurn() { pass_on(); }
    void wait() const {
        for (uint32_t now = turn_; now < number_; now = turn_)
            turn_.wait(now);
    }
    void pass_on() {
        if (passed_)
            return;
        wait();
        passed_ = true;
        turn_ = number_ + 1;
        turn_.notify_all();
    }

private:
    std::atomic<uint32_t>& turn_;
    uint32_t number_;
    bool passed_ = false;
};

} // namespace

size_t trim_draws(std::span<VisibleDraw> draws, std::span<const shared::ObjectData> objects, std::span<const Draw> all,
                  const std::function<const TrimView&(size_t)>& view_of, std::span<uint32_t> room, double& helpers_ms) {
    const std::vector<Chunk> chunks = chunks_of(draws, all, room.size());
    size_t used = 0; // by whose turn it is
    std::atomic<uint32_t> turn = 0;
    std::atomic<double> helped = 0;
    const std::thread::id caller = std::this_thread::get_id();
    parallel_for(static_cast<uint32_t>(chunks.size()), [&](uint32_t c) {
        const double start = thread_ms();
        InTurn order(turn, c);
        const std::span mine = draws.subspan(chunks[c].first, chunks[c].count);
        // Ahead of the room, where nobody knows yet how much those before take; and the room may be slow to write to.
        const auto kept = std::make_unique_for_overwrite<uint32_t[]>(chunks[c].indices);
        std::vector<std::pair<const uint32_t*, size_t>> parts(mine.size());
        IndexTrimmer trimmer({});
        const TrimView* view = nullptr; // that it looks from
        uint32_t* out = kept.get();
        for (size_t d = 0; d < mine.size(); ++d) {
            const Draw& draw = all[mine[d].draw];
            if (!is_trimmed(draw) || mine[d].index_count > room.size())
                continue;
            if (const TrimView* const own = &view_of(chunks[c].first + d); own != view)
                trimmer.look_from(*(view = own));
            parts[d] = {out, trimmer.trim(draw, objects[chunks[c].first + d], out)};
            out += parts[d].second;
        }
        order.wait();
        for (size_t d = 0; d < mine.size(); ++d) {
            const auto [from, count] = parts[d];
            if (!from || used + count > room.size()) {
                parts[d].first = nullptr;
                continue;
            }
            mine[d].first_index = static_cast<uint32_t>(used);
            mine[d].index_count = static_cast<uint32_t>(count);
            mine[d].trimmed = true;
            used += count;
        }
        order.pass_on();
        for (size_t d = 0; d < mine.size(); ++d)
            if (const auto [from, count] = parts[d]; from && count > 0)
                std::memcpy(&room[mine[d].first_index], from, count * sizeof(uint32_t));
        if (std::this_thread::get_id() != caller)
            helped += thread_ms() - start;
    });
    helpers_ms += helped;
    return used;
}

} // namespace prelight::resident
