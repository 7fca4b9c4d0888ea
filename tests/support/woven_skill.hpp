// Random skills whose modules ask, serve and send in many ways at a time.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/drawn_skill.hpp"

namespace pal::test {

/// Two to six modules with events of several periods, on one to three processors of both kinds. A module has
/// one loop, or a loop for each of its triggers in blocks of their own, or waits for the first of them. It
/// sends its requests before, in, or a round after it takes a message, in blocks that go on beside others,
/// and in branches. It also sends messages that need not be taken in time.
class WovenSkill : DrawnSkill {
 public:
  /// `calm`: events are far apart, and more is set and read, so that more is bounded.
  explicit WovenSkill(std::uint64_t seed, bool calm = false)
      : DrawnSkill(seed), messages_asked_(seed), calm_(calm) {}

  std::string text();

 private:
  void draw();

  // What the modules do a little of, and how one asks another (woven_skill_statements.cpp).
  std::string take(const Module& in, const Call& call, const std::string& indent);
  std::string set_or_read(const Module& in, const std::string& indent);
  /// Takes no message, and sends none.
  std::string small(const Module& in, const std::string& indent);
  std::string choice(const Module& in, const std::string& yes, const std::string& no,
                     const std::string& indent);
  std::string blocks(const std::string& one, const std::string& other, const std::string& indent);
  std::string asks(const Module& in, const Call& call, const std::string& indent, int depth);

  // What their rounds are made of (woven_skill_rounds.cpp).
  /// One that is not in the text yet, or any.
  const Call& next_call(Module& in);
  const std::string& next_send(Module& in);
  /// What a round does, or what is done once; calls and sends that are not in the text yet come first.
  std::string stuff(Module& in, const std::string& indent, int depth = 0);
  /// What must be in the text, in one round.
  std::string rest(Module& in, const std::string& indent, int depth);
  std::string round(Module& in, const Trigger& trigger, bool last, const std::string& indent, int depth);
  std::string loop(const std::string& inside, const std::string& indent, const Module& in);
  std::string body(Module& in);

  // What is asked about the skill (woven_skill_requirements.cpp).
  /// Some of what modules put: "message OF module".
  std::vector<std::string> messages_put();
  std::string requirements();

  std::string environment();

  std::mt19937_64 messages_asked_;  // apart, so that the skills of seeds stay what they are
  std::vector<std::pair<std::string, std::string>> read_;  // module and condition
  bool calm_;
  bool drives_ = false;
};

}  // namespace pal::test
