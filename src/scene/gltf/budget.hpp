#pragma once
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace prelight::gltf {

/// The memory that one file may take, and the work that its pictures may cost. Every allocation whose size comes from
/// the file is charged here before it is made, so that a count that lies ends in an error and not in a full machine.
///
/// Valid pictures unpack to any multiple of their stored size, so what they may take depends on the machine alone. What
/// the limits are, and why, docs/gltf.md states.
class Budget {
public:
    static constexpr uint64_t multiple = 128;                          ///< bytes of geometry per byte of input
    static constexpr uint64_t geometry_constant = uint64_t(256) << 20; ///< bytes
    static constexpr uint64_t work_multiple = 32;                      ///< pixels per byte of input
    static constexpr uint64_t work_constant = uint64_t(1) << 31;       ///< pixels

    enum class Pool { geometry, images };
    /// What `charge` throws; the caller knows which object to blame.
    struct Exceeded : std::runtime_error {
        using std::runtime_error::runtime_error;
    };

    /// `memory`: bytes that reading may plan with: a quarter each for files, geometry and pictures; what is left is for
    /// the copies that a device wants.
    explicit Budget(uint64_t memory) : share_(memory / 4) {}

    /// Most bytes that the next file may have.
    uint64_t room_for_input() const { return share_ - (input_ < share_ ? input_ : share_); }
    /// More input has been read from disk; geometry and work grow by the multiples of it.
    void add_input(uint64_t bytes) { input_ += bytes; }
    /// Throws Exceeded when the pool would pass its limit. `count` × `size` may overflow.
    void charge(Pool pool, uint64_t count, uint64_t size = 1);
    void release(Pool pool, uint64_t bytes) { used(pool) -= bytes; }
    uint64_t left(Pool pool) const;
    uint64_t limit(Pool pool) const;

    /// Pixels are going to be decoded, or bytes walked over. Throws Exceeded when all pictures together are too many.
    void charge_work(uint64_t pixels);
    /// What charge_work() still lets through.
    uint64_t work_left() const { return work_constant + work_multiple * input_ - work_; }

private:
    uint64_t& used(Pool pool) { return pool == Pool::images ? images_ : geometry_; }
    uint64_t share_;
    uint64_t input_ = 0, geometry_ = 0, images_ = 0, work_ = 0;
};

/// Charges for the time of a scope: for memory that is given back before the next object is read.
class Loan {
public:
    Loan(Budget& budget, Budget::Pool pool, uint64_t bytes) : budget_(budget), pool_(pool), bytes_(bytes) {
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
