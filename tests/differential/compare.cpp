#include "tests/differential/compare.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <numeric>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "analyzer/compositional/compositional.hpp"
#include "analyzer/exact/exact.hpp"
#include "analyzer/verdict/refuted.hpp"
#include "tests/differential/contradiction.hpp"
#include "tests/support/any_skill.hpp"

using namespace pal::analyzer;

namespace pal::test {
namespace {

constexpr Duration longest = std::chrono::seconds(1);

struct Times {
  Duration grain{1};     // what all times of a text are multiples of
  Duration greatest{0};  // no time is longer, but for what is less than its unit
};

Times times_of(const std::string& text) {
  static const std::regex time(R"(([0-9]+)(?:\.([0-9]+))?(?: TO [0-9.]+)? ?(ns|us|ms|s|min)\b)");
  static const std::regex last(R"( TO ([0-9]+)(?:\.([0-9]+))? ?(ns|us|ms|s|min)\b)");
  static const std::map<std::string, std::int64_t> units = {
      {"ns", 1}, {"us", 1'000}, {"ms", 1'000'000}, {"s", 1'000'000'000}, {"min", 60'000'000'000}};
  std::int64_t common = 0;
  Times all;
  const auto take = [&](const std::string& whole, const std::string& digits, std::int64_t unit) {
    std::int64_t least = unit;
    for (std::size_t i = 0; i < digits.size(); ++i) least /= 10;
    common = std::gcd(common, std::stoll(whole) * unit + (digits.empty() ? 0 : std::stoll(digits) * least));
    all.greatest = std::max(all.greatest, Duration(std::stoll(whole) * unit));
  };
  for (const std::regex& each : {time, last}) {
    for (std::sregex_iterator at(text.begin(), text.end(), each), end; at != end; ++at)
      take((*at)[1], (*at)[2], units.at((*at)[3]));
  }
  all.grain = Duration(std::max<std::int64_t>(common, 1));
  return all;
}

/// Whether times are such that runs can be made of them: those count units of time in 32 bits.
bool can_run(const Times& times) {
  return times.greatest / times.grain < std::numeric_limits<std::int32_t>::max() / 4;
}

const Verdict* of(const Analysis& analysis, const std::string& requirement) {
  for (const Verdict& each : analysis.verdicts) {
    if (each.requirement == requirement) return &each;
  }
  return nullptr;
}

std::string claim(const Verdict& verdict) {
  std::ostringstream out;
  out << verdict.requirement << ": " << name(verdict.method) << " " << name(verdict.state);
  if (verdict.bound) out << " " << verdict.bound->count();
  out << ", " << verdict.explanation.text() << "\n";
  return out.str();
}

/// Whether the run of the exact analysis goes beyond what the other one proved.
bool refuted_by(const Verdict& exact, Verdict compositional) {
  compositional.witness = exact.witness;
  compositional.attained_load = exact.attained_load;
  return is_refuted(compositional);
}

class Comparison {
 public:
  Comparison(const std::string& text, const Skill& skill, Duration unit, std::uint64_t seed,
             const Effort& effort)
      : text_(text),
        network_(skill.specification.skills.front()),
        environment_(skill.specification.environments.front()),
        unit_(unit),
        cap_(static_cast<int>(longest / unit_)),
        seed_(seed),
        effort_(effort) {
    Problem problem = *skill.problem;
    compositional_ = compositional::analyze(problem);
    if (effort.only_bounded) leave_bounded(problem);
    Options options;
    options.max_states = effort.classes;
    exact_ = analyze_exactly(problem, options);
  }

  Compared result() {
    compared_.skills = 1;
    for (const Wanted& wanted : wanted(network_, environment_)) {
      if (compared_.contradiction.empty()) requirement(wanted);
    }
    return compared_;
  }

 private:
  void leave_bounded(Problem& problem) {
    std::vector<Requirement> kept;
    for (std::size_t r = 0; r < problem.requirements.size(); ++r) {
      if (compositional_.verdicts[r].bound) kept.push_back(problem.requirements[r]);
    }
    problem.requirements = std::move(kept);
  }

  void requirement(const Wanted& wanted) {
    const Verdict* exact = of(exact_, wanted.name);
    const Verdict* compositional = of(compositional_, wanted.name);
    if (effort_.only_bounded && compositional != nullptr && !compositional->bound) return;
    if (exact == nullptr || compositional == nullptr) {
      compared_.contradiction = wanted.name + " has no verdict\n" + text_;
      return;
    }
    if (refuted_by(*exact, *compositional)) {
      compared_.contradiction = claim(*exact) + claim(*compositional) + text_;
      return;
    }
    if (wanted.kind == Wanted::Kind::load) return;
    ++compared_.requirements;
    compared_.exact += exact->bound ? 1 : 0;
    compared_.bounded += compositional->bound ? 1 : 0;
    bool measured = false;
    for (std::uint64_t walk = 0; walk < effort_.walks && compared_.contradiction.empty(); ++walk) {
      AllRuns runs(network_, environment_, wanted, unit_, cap_);
      const Seen seen = run(runs, walk);
      measured = measured || seen.greatest >= 0 || seen.least >= 0;
      for (const Verdict* verdict : {exact, compositional}) {
        const std::string wrong = contradiction(wanted, seen, *verdict, unit_, cap_);
        if (wrong.empty()) continue;
        compared_.contradiction = claim(*verdict) + wrong + "\n" + text_ + story(runs, walk);
        break;
      }
    }
    compared_.measured += measured ? 1 : 0;
  }

  Seen run(AllRuns& runs, std::uint64_t walk) const {
    BiasedDecisions decisions(seed_ * 1000 + walk);
    return runs.walk(decisions, effort_.things);
  }

  std::string story(AllRuns& runs, std::uint64_t walk) const {
    runs.tell = true;
    run(runs, walk);
    std::string out;
    for (const std::string& line : runs.story) out += line + "\n";
    return out;
  }

  const std::string& text_;
  const pan::Network& network_;
  const pan::Environment& environment_;
  Duration unit_;
  int cap_;
  std::uint64_t seed_;
  Effort effort_;
  Analysis exact_;
  Analysis compositional_;
  Compared compared_;
};

}  // namespace

Compared& Compared::operator+=(const Compared& other) {
  skills += other.skills;
  requirements += other.requirements;
  exact += other.exact;
  bounded += other.bounded;
  measured += other.measured;
  if (contradiction.empty()) contradiction = other.contradiction;
  return *this;
}

Compared compare(const std::string& text, std::uint64_t seed, const Effort& effort) {
  const auto skill = any_skill(text);
  const Times times = times_of(text);
  if (!skill->problem || !can_run(times)) return {};
  return Comparison(text, *skill, times.grain, seed, effort).result();
}

}  // namespace pal::test
