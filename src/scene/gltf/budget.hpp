#pragma once
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace prelight::gltf {

/// The memory that one file may take. Every allocation whose size comes from the file is charged
/// here before it is made, so that a count that lies ends in an error and not in a full machine.
/// The limits are those that docs/gltf.md states: per byte read, and a constant for small files.
class Budget {
public:
    static constexpr uint64_t multiple = 128;                         ///< bytes per byte of input
    static constexpr uint64_t geometry_constant = uint64_t(64) << 20; ///< bytes
    static constexpr uint64_t image_constant = uint64_t(512) << 20;   ///< bytes

    enum class Pool { geometry, images };
    /// What `charge` throws; the caller knows which object to blame.
    struct Exceeded : std::runtime_error {
        using std::runtime_error::runtime_error;
    };

    /// More input has been read from disk; both pools grow by the multiple of it.
    void add_input(uint64_t bytes) { input_ += bytes; }
    /// Throws Exceeded when the pool would pass its limit. `count` × `size` may overflow.
    void charge(Pool pool, uint64_t count, uint64_t size = 1);
    void release(Pool pool, uint64_t bytes) { used(pool) -= bytes; }
    uint64_t left(Pool pool) const;
    uint64_t limit(Pool pool) const;

private:
    uint64_t& used(Pool pool) { return pool == Pool::images ? images_ : geometry_; }
    uint64_t input_ = 0, geometry_ = 0, images_ = 0;
};

/// Charges for the time of a scope: for memory that is given back before the next object is read.
class Loan {
public:
    Loan(Budget& budget, Budget::Pool pool, uint64_t bytes)
        : budget_(budget), pool_(pool), bytes_(bytes) {
        budget.charge(pool, bytes);
    }
    ~Loan() { budget_.release(pool_, bytes_); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

private:
    Budget& budget_;
    Budget::Pool pool_;
    uint64_t bytes_;
};

} // namespace prelight::gltf
