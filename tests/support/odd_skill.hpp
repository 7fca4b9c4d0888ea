// Random skills whose modules take what others send in the middle of their rounds, and give up.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/support/drawn_skill.hpp"

namespace pal::test {

/// A method, one or two controllers with events far apart, and a sensor that is asked. A module takes one
/// message at the beginning of its rounds. It takes the others somewhere else: within a limit, as one of
/// several, in another block, or before its rounds. Odd things happen:
/// - clients give up or are cancelled while they are answered;
/// - blocks leave their rounds and end the skill;
/// - a module is executed in several places;
/// - slots are filled before a thread takes from them.
///
/// Calm skills have one trigger a module and little that is odd, so that more is bounded. Their clients wait
/// for one another. Or a sensor asks before it has finished its work, and sends to a slow method.
class OddSkill : DrawnSkill {
 public:
  explicit OddSkill(std::uint64_t seed, bool calm = false);

  std::string text();

 private:
  enum class Odd { tests, limits, asks, twice, arms, beside, before, within, leaves, executes };

  /// Of what is odd only some is in one skill, so that something is bounded.
  bool odd(Odd what, int one_in) { return odd_[static_cast<std::size_t>(what)] == 0 && chance_(one_in) == 0; }

  // Which modules talk to which (odd_skill.cpp).
  void draw();
  void calm_links();

  // What the modules do a little of, and how one asks another (odd_skill_statements.cpp).
  /// Takes no message, and sends none.
  std::string small(const Module& in, const std::string& indent);
  std::string choice(const Module& in, const std::string& yes, const std::string& no,
                     const std::string& indent);
  std::string limited(const Module& in, const std::string& wait, const std::string& then,
                      const std::string& indent);
  std::string serve(const Module& in, const Trigger& trigger, const std::string& indent);
  std::string take(const Module& in, const Call& call, const std::string& indent);
  std::string asks(const Module& in, const Call& call, const std::string& indent);

  // What their rounds are made of (odd_skill_rounds.cpp).
  /// What a round does besides what it takes.
  std::string stuff(Module& in, const std::string& indent);
  std::string loop(const Module& in, const std::string& inside, const std::string& indent);
  /// What is asked for in one round is taken in the next.
  std::string polling(const Module& in, const std::string& indent);
  /// One of the triggers begins a round; the others are taken elsewhere.
  std::string rounds(Module& in, const std::string& indent);
  /// Blocks, of which one is cancelled that sets what is read in the next ones.
  std::string one_after_the_other(const Module& in);
  std::string body(Module& in);
  std::string contingency();

  std::string requirements();
  std::string environment();

  int odd_[10] = {};               // by Odd; 0: it is
  std::vector<std::string> ages_;  // "condition AT statement IN module"
  bool calm_;
  std::string polls_;  // the module that asks before it has finished; nothing: there is none
  bool second_ = false;
  bool contingency_ = false;
};

}  // namespace pal::test
