// Random skills that no person would write, with every statement of the language in every place. The
// workcells are of every kind, with times so small that all runs can be tried.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/support/chance.hpp"

namespace pal::test {

/// The text of a skill and its environment; all times are whole milliseconds, none above `longest`. The same
/// seed gives the same text. `deep` bounds how far statements stand inside one another.
class RandomCell {
 public:
  /// What the skill is required to keep: an age, a response; or something of every measure.
  enum class Asks { little, all };

  RandomCell(std::uint64_t seed, int longest, int deep = 2, Asks asks = Asks::little)
      : chance_(seed),
        required_(seed),
        executed_(~seed),
        longest_(longest),
        deep_(deep),
        asks_(asks),
        asks_events_(seed % 4 == 1) {}

  std::string text();

 private:
  using Lines = std::vector<std::string>;

  static std::string ms(int time) { return std::to_string(time) + " ms"; }

  /// Some requirements of the other measures; drawn apart, so that the skill is the same without them.
  std::string requirements();

  // Statements of every kind (random_cell_statements.cpp).
  std::string guard();
  /// WTM( what ) in one of its forms.
  std::string wait(const std::string& what, int deeper);
  std::string few(int deeper);
  /// A statement of the module that is being written.
  std::string statement(int deeper);
  /// The backbone, with statements thrown in and a few of its own out of order.
  std::string mixed(Lines lines);

  // What the modules do (random_cell_modules.cpp).
  std::string bodies();
  std::string sensors();
  std::string controller();
  std::string method();
  /// A CONCURRENT in the module that is executed; drawn apart, so that other skills are the same without.
  std::string executed_blocks();
  std::string call() { return blocks_ && executed_() % 2 == 0 ? "Execute CM1\n" : ""; }
  void begin(Lines activities, Lines sends, Lines waits);

  // The workcell and its times (random_cell_environment.cpp).
  std::string place(const std::string& thread, int processors);
  std::string event(const std::string& device, const std::string& message, bool answer);
  std::string environment();

  Chance chance_;
  std::mt19937_64 required_;
  std::mt19937_64 executed_;
  int longest_;
  int deep_;
  Asks asks_;
  bool asks_events_;  // requests go to a sensor that sends by itself, too
  int sensor_ = 0;
  bool controller_ = true;
  bool lonely_ = false;
  bool sets_ = false;
  bool executes_ = false;
  bool blocks_ = false;
  Lines activities_, sends_, waits_, backbone_;
};

}  // namespace pal::test
