// Decides what the skill and the world leave open.
#pragma once

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace pal::test {

class Decisions {
 public:
  virtual ~Decisions() = default;
  /// One of 0 … n-1.
  virtual int pick(int n) = 0;
};

class RandomDecisions final : public Decisions {
 public:
  explicit RandomDecisions(std::uint64_t seed) : engine_(seed) {}
  int pick(int n) override { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }

 private:
  std::mt19937_64 engine_;
};

/// Random, with a preference for the first or the last: times at the ends of their intervals, phases
/// together.
class BiasedDecisions final : public Decisions {
 public:
  explicit BiasedDecisions(std::uint64_t seed) : engine_(seed), habit_(static_cast<int>(engine_() % 4)) {}
  int pick(int n) override {
    const int any = static_cast<int>(engine_() % static_cast<std::uint64_t>(n));
    const bool by_habit = engine_() % 8 != 0;
    if (habit_ == 0 || !by_habit) return any;
    return habit_ == 1 || (habit_ == 2 && engine_() % 2 == 0) ? n - 1 : 0;
  }

 private:
  std::mt19937_64 engine_;
  int habit_;
};

/// Goes through all sequences of decisions.
class AllDecisions final : public Decisions {
 public:
  int pick(int n) override {
    if (at_ == taken_.size()) taken_.push_back({0, n});
    return taken_[at_++].first;
  }
  std::vector<int> decided() const {
    std::vector<int> all;
    for (const auto& [taken, of] : taken_) all.push_back(taken);
    return all;
  }
  bool next() {
    at_ = 0;
    while (!taken_.empty() && taken_.back().first + 1 == taken_.back().second) taken_.pop_back();
    if (taken_.empty()) return false;
    ++taken_.back().first;
    return true;
  }

 private:
  std::vector<std::pair<int, int>> taken_;
  std::size_t at_ = 0;
};

/// Decides what was decided before.
class RecordedDecisions final : public Decisions {
 public:
  explicit RecordedDecisions(std::vector<int> decided) : decided_(std::move(decided)) {}
  int pick(int) override { return decided_[at_++]; }

 private:
  std::vector<int> decided_;
  std::size_t at_ = 0;
};

}  // namespace pal::test
