// Runs that are told by hand, event by event, for the referee to judge.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <string>

#include "analyzer/run_checker/check_run.hpp"
#include "analyzer/runs/simulate.hpp"
#include "tests/support/any_skill.hpp"

namespace pal::test {

/// Runs of a skill that are told by hand.
class Told {
 public:
  explicit Told(const std::string& text) : skill_(any_skill(text)) {
    INFO(messages(skill_->diagnostics));
    REQUIRE(skill_->problem);
    const analyzer::Watch nothing;
    run_ = analyzer::simulate(analyzer::Machine(*skill_->problem, nothing), {}).trace;
    run_.events.clear();
  }

  /// What follows is at this time.
  Told& at(std::int64_t milliseconds) {
    now_ = milliseconds * 1'000'000;
    return *this;
  }

  /// `actor`: "-" is none; `subject`: a condition or a message; `value`: of a condition, the number of a
  /// message, or a code.
  Told& say(trace::Kind kind, const std::string& actor, const std::string& statement = {},
            const std::string& subject = {}, int value = 0) {
    trace::Event event{};
    event.time_ns = now_;
    event.kind = kind;
    event.actor = -1;
    if (actor != "-")
      event.actor = index(run_.actors, [&](const trace::Actor& each) { return each.name == actor; });
    event.statement = -1;
    if (!statement.empty()) {
      event.statement =
          index(run_.statements, [&](const trace::Statement& each) { return each.text == statement; });
    }
    const bool condition = kind == trace::Kind::set || kind == trace::Kind::read;
    event.subject = -1;
    if (condition) {
      event.subject = index(run_.conditions, [&](const std::string& each) { return each == subject; });
    } else if (!subject.empty()) {
      event.subject =
          index(run_.channels, [&](const trace::Channel& each) { return each.message == subject; });
    }
    event.value = value;
    run_.events.push_back(event);
    return *this;
  }

  /// Which rule it breaks; empty: none.
  std::string broken() const {
    return analyzer::run_checker::check_run(*skill_->problem, &skill_->problem->requirements.front(), run_)
        .broken;
  }

 private:
  template <typename List, typename Is>
  static std::int32_t index(const List& list, const Is& is) {
    const auto found = std::find_if(list.begin(), list.end(), is);
    REQUIRE(found != list.end());
    return static_cast<std::int32_t>(found - list.begin());
  }

  std::unique_ptr<Skill> skill_;
  trace::Trace run_;
  std::int64_t now_ = 0;
};

}  // namespace pal::test
