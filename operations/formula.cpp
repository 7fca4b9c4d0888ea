#include "operations/formula.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace pal::operations {

/// By the usual order: sums of products of factors.
class FormulaReader {
 public:
  explicit FormulaReader(const std::string& text) : text_(text) {}

  std::optional<Formula> whole() {
    Formula result;
    result.text_ = text_;
    if (!sum(result) || !at_end()) return std::nullopt;
    return result;
  }

 private:
  using Kind = Formula::Kind;
  static constexpr int most_nested = 50;

  static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }

  bool at_end() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ == text_.size();
  }
  bool takes(char wanted) {
    if (at_end() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }

  bool sum(Formula& to) {
    if (!product(to)) return false;
    for (;;) {
      const bool more = takes('+');
      if (!more && !takes('-')) return true;
      if (!product(to)) return false;
      to.steps_.push_back({more ? Kind::add : Kind::subtract});
    }
  }
  bool product(Formula& to) {
    if (!factor(to)) return false;
    for (;;) {
      const bool times = takes('*');
      if (!times && !takes('/')) return true;
      if (!factor(to)) return false;
      to.steps_.push_back({times ? Kind::multiply : Kind::divide});
    }
  }
  bool factor(Formula& to) {
    if (++nested_ > most_nested) return false;
    const bool read = one(to);
    --nested_;
    return read;
  }
  bool one(Formula& to) {
    if (takes('(')) return sum(to) && takes(')');
    if (at_end()) return false;
    if (is_digit(text_[at_])) {
      Formula::Step step;
      const auto [end, problem] =
          std::from_chars(text_.data() + at_, text_.data() + text_.size(), step.number);
      if (problem != std::errc()) return false;
      at_ = static_cast<std::size_t>(end - text_.data());
      to.steps_.push_back(std::move(step));
      return true;
    }
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           (is_letter(text_[at_]) || (at_ > begin && (is_digit(text_[at_]) || text_[at_] == '-'))))
      ++at_;
    std::string name = text_.substr(begin, at_ - begin);
    if (name.empty() || name.back() == '-') return false;
    if (!takes('(')) {
      to.steps_.push_back({Kind::name, 0, std::move(name)});
      return true;
    }
    const Kind kind = name == "abs" ? Kind::abs : name == "max" ? Kind::max : Kind::norm;
    if (kind == Kind::norm && name != "norm") return false;
    std::size_t count = 0;
    do {
      if (!sum(to)) return false;
      ++count;
    } while (takes(','));
    if (!takes(')') || (kind == Kind::abs && count != 1)) return false;
    to.steps_.push_back({kind, 0, {}, count});
    return true;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int nested_ = 0;
};

std::optional<Formula> Formula::parse(const std::string& text) {
  return FormulaReader(text).whole();
}

namespace {

ValueRange abs_of(ValueRange x) {
  const bool around = x.low <= 0 && x.high >= 0;
  return {around ? 0 : std::min(std::abs(x.low), std::abs(x.high)),
          std::max(std::abs(x.low), std::abs(x.high))};
}

ValueRange product(ValueRange a, ValueRange b) {
  const auto [least, most] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {least, most};
}

}  // namespace

std::optional<ValueRange> Formula::over(const Values& values) const {
  std::vector<ValueRange> known;
  for (const Step& step : steps_) {
    if (step.kind == Kind::number) {
      known.push_back({step.number, step.number});
      continue;
    }
    if (step.kind == Kind::name) {
      const auto value = values(step.name);
      if (!value) return std::nullopt;
      known.push_back(*value);
      continue;
    }
    const std::size_t count = step.kind == Kind::abs ? 1 : step.count;
    std::vector<ValueRange> of(known.end() - static_cast<std::ptrdiff_t>(count), known.end());
    known.resize(known.size() - count);
    ValueRange result = of.front();
    switch (step.kind) {
      case Kind::add:
        result = {of[0].low + of[1].low, of[0].high + of[1].high};
        break;
      case Kind::subtract:
        result = {of[0].low - of[1].high, of[0].high - of[1].low};
        break;
      case Kind::multiply:
        result = product(of[0], of[1]);
        break;
      case Kind::divide:
        if (of[1].low <= 0 && of[1].high >= 0) return std::nullopt;
        result = product(of[0], {1 / of[1].high, 1 / of[1].low});
        break;
      case Kind::abs:
        result = abs_of(of[0]);
        break;
      case Kind::max:
        for (const ValueRange& each : of)
          result = {std::max(result.low, each.low), std::max(result.high, each.high)};
        break;
      case Kind::norm:
        result = {};
        for (const ValueRange& each : of) {
          const ValueRange size = abs_of(each);
          result = {std::hypot(result.low, size.low), std::hypot(result.high, size.high)};
        }
        break;
      case Kind::number:
      case Kind::name:
        break;
    }
    if (!std::isfinite(result.low) || !std::isfinite(result.high)) return std::nullopt;
    known.push_back(result);
  }
  return known.front();
}

}  // namespace pal::operations
