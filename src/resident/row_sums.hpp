#pragma once
#include <cstddef>
#include <cstdint>
#include <prelight/image.hpp>
#include <span>
#include <vector>

namespace prelight::resident {

/// A map with the sums of its rows from the left, over two turns, channel by channel: a difference of two sums is the
/// sum of columns, also round the edge.
class RowSums {
public:
    /// `channels`: 3, or 1 of a grey map. `step`: of the columns that add() reads one after another; a power of two, at
    /// most the width.
    RowSums(const Image& image, uint32_t channels, uint32_t step);
    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }

    /// Some columns of a row and of the row below it, each row with a weight of its own.
    struct Window {
        uint32_t upper = 0, lower = 0; ///< rows
        double upper_weight = 0, lower_weight = 0;
        double from = 0, columns = 0; ///< parts of columns too
    };
    /// out[i] += the window's weighted sum, moved i · step to the right; i · step < width.
    void add(std::span<double> out, uint32_t channel, const Window& window) const;

private:
    /// A place in a row of sums: between a sum and the next one, after whole turns.
    struct Place {
        size_t sum = 0, next = 0; ///< indices in a row
        double share = 0;         ///< of the next one
        double turns = 0;
    };
    Place place_of(double column) const;
    const double* row(uint32_t channel, uint32_t y) const {
        return &sums_[(size_t(y) * channels_ + channel) * stride_];
    }
    size_t index(uint32_t column) const { return column % step_ * run_ + column / step_; }

    uint32_t width_, height_, channels_, step_;
    size_t run_;    ///< of sums that are `step` columns apart, which lie side by side
    size_t stride_; ///< of a row and channel
    std::vector<double> sums_;
};

} // namespace prelight::resident
