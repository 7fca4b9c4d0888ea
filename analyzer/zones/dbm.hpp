// Difference bound matrices: what is known of a set of times, as bounds on their differences.
//
// D. L. Dill, Timing assumptions and verification of finite-state concurrent systems, 1989. All bounds are
// closed, so whole nanoseconds suffice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pal::analyzer {

/// Bounds x[i] - x[j] <= at(i, j) of variables x[0] = 0, x[1], …. They are always closed: every bound is as
/// tight as the others make it. They are never empty, except after a constrain() that returned false.
class Dbm {
 public:
  static constexpr std::int64_t unbounded = INT64_MAX / 4;

  explicit Dbm(std::size_t size = 1) : size_(size), bounds_(size * size, 0) {}

  std::size_t size() const { return size_; }
  /// As new, of another size, in the memory that it has.
  void reset(std::size_t size) {
    size_ = size;
    bounds_.assign(size * size, 0);
  }
  std::int64_t& at(std::size_t i, std::size_t j) { return bounds_[i * size_ + j]; }
  std::int64_t at(std::size_t i, std::size_t j) const { return bounds_[i * size_ + j]; }

  static std::int64_t sum(std::int64_t a, std::int64_t b) {
    return a >= unbounded || b >= unbounded ? unbounded : a + b;
  }

  /// Adds x[i] - x[j] <= bound and closes again. False: nothing is left.
  bool constrain(std::size_t i, std::size_t j, std::int64_t bound);

  /// Whether all of `other`, of the same size, is in this one.
  bool includes(const Dbm& other) const;

  friend bool operator==(const Dbm&, const Dbm&) = default;

 private:
  std::size_t size_;
  std::vector<std::int64_t> bounds_;
};

}  // namespace pal::analyzer
