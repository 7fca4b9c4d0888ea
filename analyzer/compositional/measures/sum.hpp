// Times with the terms that they are made of.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "analyzer/compositional/causes/ids.hpp"
#include "analyzer/compositional/causes/saturating.hpp"

namespace pal::analyzer::compositional {

/// One term of a sum.
struct Term {
  enum class Kind {
    latest,       // effect of `step` in `node` at the latest; of its last step: without `step`
    since_event,  // the same, counted from the event itself
    since_cause,  // the same, counted from the latest release of `cause`
    earliest,     // and at the earliest
    release,      // of `node` at the latest
    gap,          // from one occurrence of `source` to the next, at the latest
    first,        // from time 0 to its first
    said,         // `what`
  };
  Kind kind = Kind::said;
  NodeId node{};  // said: a node of the thread that does it; -1: none does
  StepId step{};
  SourceId source{};
  std::string what;
  NodeId cause{};  // node
};

/// A time or a difference of times, with the terms it is made of. Saturates at `never`, which has no terms.
class Sum {
 public:
  Sum() = default;
  Sum(Nanoseconds amount, Term term);
  static Sum unbounded() { return Sum(never); }
  /// A number without a term.
  static Sum number(Nanoseconds value) { return Sum(value); }

  Nanoseconds value() const { return value_; }
  bool bounded() const { return value_ < never; }

  friend Sum operator+(const Sum& one, const Sum& other);
  friend Sum operator-(const Sum& one, const Sum& other);

  struct Addend {
    Nanoseconds amount;  // negative: taken away
    Term term;
  };
  /// They add up to value().
  std::vector<Addend> addends() const;

 private:
  struct Made {
    Term term;                               // a leaf's
    std::shared_ptr<const Made> one, other;  // of a node
    Nanoseconds amount = 0;                  // a leaf's
    bool minus = false;                      // the other is taken away
  };
  explicit Sum(Nanoseconds value) : value_(value) {}
  Sum(Nanoseconds value, std::shared_ptr<const Made> made) : value_(value), made_(std::move(made)) {}
  static void collect(const Made* made, bool minus, std::vector<Addend>& out);

  Nanoseconds value_ = 0;
  std::shared_ptr<const Made> made_;  // nothing: there is no term
};

inline const Sum& greater(const Sum& one, const Sum& other) {
  return other.value() > one.value() ? other : one;
}
inline const Sum& less(const Sum& one, const Sum& other) {
  return other.value() < one.value() ? other : one;
}

}  // namespace pal::analyzer::compositional
