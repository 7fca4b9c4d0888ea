#include "analyzer/load/share_bound.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <numeric>

#include "analyzer/load/cycle_ratio.hpp"
#include "analyzer/runs/solver_context.hpp"

namespace pal::analyzer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t most_cycles = 2000;
/// Shares that one cycle counts, and the time of one linear program: with more of either the next one might
/// take seconds. It cannot be interrupted: Z3's optimizer (4.8) crashes where that happens after it found
/// values and before it took them.
constexpr std::size_t most_passing = 100;
constexpr auto longest_program = std::chrono::milliseconds(500);
/// Greater denominators than this are rounded.
constexpr std::int64_t most_parts = 1'000'000'000'000'000;
/// What rounding may add.
constexpr std::int64_t least_part = 1'000'000'000'000;
/// Times round a cycle, in nanoseconds: less than 2^68, so that their products with shares, of which none has
/// more than 2^50 parts, add up in 128 bits.
constexpr Gain longest_round = static_cast<Gain>(1) << 68;

/// Work and what passes round a cycle.
struct Round {
  Gain work = 0;
  std::map<int, Gain> passing;  // by share
};

/// Shares and their bound, in parts of `whole`.
struct Shares {
  std::int64_t whole = 1;
  std::int64_t bound = 0;
  std::vector<std::int64_t> each;
};

/// The linear program: the least bound for the cycles known.
class Program {
 public:
  explicit Program(const WorkGraph& graph)
      : context_(solver_context()), solver_(context_), bound_(context_.real_const("bound")) {
    z3::params parameters(context_);
    // Z3 would keep a Ctrl-C to itself.
    parameters.set("ctrl_c", false);
    solver_.set(parameters);
    solver_.add(bound_ >= 0 && bound_ <= 1);
    for (int s = 0; s < graph.shares; ++s) {
      shares_.push_back(context_.real_const(("s" + std::to_string(s)).c_str()));
      solver_.add(shares_.back() >= 0 && shares_.back() <= bound_);
    }
    for (const std::vector<int>& together : graph.together) {
      if (together.size() < 2) continue;
      z3::expr_vector added(context_);
      for (int s : together) added.push_back(shares_[static_cast<std::size_t>(s)]);
      solver_.add(z3::sum(added) <= bound_);
    }
    solver_.minimize(bound_);
  }

  void add(const Round& round) {
    // One sum of all: of sums within sums each is rewritten by itself, which nothing interrupts.
    z3::expr_vector passed(context_);
    passed.push_back(context_.real_val(0));
    for (const auto& [share, time] : round.passing)
      passed.push_back(number(time) * shares_[static_cast<std::size_t>(share)]);
    solver_.add(z3::sum(passed) >= number(round.work));
  }

  /// Nothing: the numbers are too long.
  std::optional<Shares> solve() {
    const Clock::time_point begin = Clock::now();
    if (solver_.check() != z3::sat) return std::nullopt;
    slow_ = Clock::now() - begin > longest_program;
    const z3::model model = solver_.get_model();
    std::vector<std::pair<std::int64_t, std::int64_t>> values;
    std::vector<z3::expr> all = shares_;
    all.push_back(bound_);
    for (const z3::expr& each : all) {
      const z3::expr value = model.eval(each, true);
      std::int64_t above = 0;
      std::int64_t below = 1;
      if (!value.numerator().is_numeral_i64(above) || !value.denominator().is_numeral_i64(below))
        return std::nullopt;
      values.emplace_back(above, below);
    }
    return in_parts(values);
  }

  /// The last solution took too long: no other should be asked for.
  bool slow() const { return slow_; }

 private:
  z3::expr number(Gain value) {
    constexpr std::int64_t whole = 1'000'000'000'000'000'000;
    return context_.real_val(static_cast<std::int64_t>(value / whole)) * context_.real_val(whole) +
           context_.real_val(static_cast<std::int64_t>(value % whole));
  }

  /// All with one denominator. If that would be too great each is rounded up a little, and the bound more.
  static Shares in_parts(const std::vector<std::pair<std::int64_t, std::int64_t>>& values) {
    Shares made;
    for (const auto& [above, below] : values) {
      const std::int64_t factor = below / std::gcd(made.whole, below);
      if (made.whole > most_parts / factor) return rounded(values);
      made.whole *= factor;
    }
    for (const auto& [above, below] : values) made.each.push_back(above * (made.whole / below));
    made.bound = made.each.back();
    made.each.pop_back();
    return made;
  }

  static Shares rounded(const std::vector<std::pair<std::int64_t, std::int64_t>>& values) {
    Shares made;
    made.whole = most_parts;
    for (const auto& [above, below] : values) {
      const Gain part = static_cast<Gain>(above) * made.whole / below;
      made.each.push_back(static_cast<std::int64_t>(part + part / least_part));
    }
    made.bound = std::min(made.whole, made.each.back() + static_cast<std::int64_t>(made.each.size()));
    made.each.pop_back();
    return made;
  }

  z3::context& context_;
  z3::optimize solver_;
  z3::expr bound_;
  std::vector<z3::expr> shares_;
  bool slow_ = false;
};

bool keep_the_bound(const WorkGraph& graph, const Shares& shares) {
  const auto value = [&shares](int s) { return shares.each[static_cast<std::size_t>(s)]; };
  for (const std::vector<int>& together : graph.together) {
    Gain sum = 0;
    for (int s : together) sum += value(s);
    if (sum > shares.bound) return false;
  }
  return std::all_of(shares.each.begin(), shares.each.end(),
                     [&shares](std::int64_t s) { return s >= 0 && s <= shares.whole; });
}

bool can_add_up(const WorkGraph& graph) {
  Gain longest = 0;
  for (const WorkEdge& edge : graph.edges) {
    Gain times = edge.work;
    for (const Passing& passing : edge.passing) times += std::abs(passing.time);
    longest = std::max(longest, times);
  }
  return longest * graph.nodes < longest_round;
}

std::vector<Gain> gains(const WorkGraph& graph, const Shares& shares) {
  std::vector<Gain> made;
  made.reserve(graph.edges.size());
  for (const WorkEdge& edge : graph.edges) {
    Gain gain = static_cast<Gain>(edge.work) * shares.whole;
    for (const Passing& passing : edge.passing)
      gain -= static_cast<Gain>(passing.time) * shares.each[static_cast<std::size_t>(passing.share)];
    made.push_back(gain);
  }
  return made;
}

Round round_of(const WorkGraph& graph, const std::vector<int>& cycle) {
  Round round;
  for (int e : cycle) {
    const WorkEdge& edge = graph.edges[static_cast<std::size_t>(e)];
    round.work += edge.work;
    for (const Passing& passing : edge.passing) round.passing[passing.share] += passing.time;
  }
  return round;
}

std::optional<Fraction> search(const WorkGraph& graph, const std::optional<Fraction>& limit,
                               const std::function<bool()>& stop) {
  std::vector<std::pair<int, int>> ends;
  ends.reserve(graph.edges.size());
  for (const WorkEdge& edge : graph.edges) ends.emplace_back(edge.from, edge.to);
  PositiveCycle cycles(graph.nodes, std::move(ends));
  Program program(graph);
  for (std::size_t n = 0; n < most_cycles && !(stop && stop()); ++n) {
    const auto shares = program.solve();
    if (!shares || !keep_the_bound(graph, *shares)) return std::nullopt;
    const Fraction bound{shares->bound, shares->whole};
    if (limit && greater(bound, *limit)) return std::nullopt;
    const std::vector<int> cycle = cycles.find(gains(graph, *shares));
    if (cycle.empty()) return bound;
    if (program.slow()) return std::nullopt;
    const Round round = round_of(graph, cycle);
    if (round.passing.size() > most_passing) return std::nullopt;
    program.add(round);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Fraction> share_bound(const WorkGraph& graph, const std::optional<Fraction>& limit,
                                    const std::function<bool()>& stop) {
  const bool works =
      std::any_of(graph.edges.begin(), graph.edges.end(), [](const WorkEdge& edge) { return edge.work > 0; });
  if (!works) return Fraction{0, 1};
  if (!can_add_up(graph)) return std::nullopt;
  try {
    return search(graph, limit, stop);
  } catch (const z3::exception&) {
    return std::nullopt;
  }
}

}  // namespace pal::analyzer
