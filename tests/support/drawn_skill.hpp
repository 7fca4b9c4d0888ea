// The parts of random skills whose modules ask, serve and send.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/chance.hpp"

namespace pal::test {

/// A random skill that is being made. It has the modules, their channels and statements, the possible
/// requirements, and the processors of the workcell. Each kind of skill makes the rounds of its modules from
/// it.
class DrawnSkill {
 protected:
  struct Trigger {
    std::string wait;   // "tick from robot"
    std::string reply;  // a statement, or nothing
  };
  struct Call {
    std::string message;
    std::string server;
  };
  struct Module {
    std::string kind;
    std::string name;
    std::vector<Trigger> triggers = {};
    std::vector<Call> calls = {};
    std::vector<std::string> sends = {};
    std::size_t called = 0;  // how many calls are in the text
    std::size_t sent = 0;
  };

  explicit DrawnSkill(std::uint64_t seed) : chance_(seed) {}
  ~DrawnSkill() = default;

  // Which modules talk to which.
  Module& module(const std::string& name);
  void serves(const std::string& server, const std::string& client, const std::string& message);
  void sends(const std::string& from, const std::string& to, const std::string& message);

  /// The messages, a condition of each module, and the two devices that all these skills have.
  std::string declarations() const;

  /// The beginning of a module's text: three activities, w1 to w3 and the module's name.
  static std::string head(const std::string& kind, const std::string& name);

  // Statements, with their lines.
  /// One of which something may be required.
  std::string say(const Module& in, const std::string& statement, const std::string& indent);
  std::string work(const Module& in, const std::string& indent);
  std::string ask(const Module& in, const Call& call, const std::string& indent);
  static std::string answer_of(const Call& call);
  static std::string cases(const std::string& condition, const std::string& then, const std::string& other,
                           const std::string& otherwise, const std::string& indent);
  static std::string concurrent(const std::vector<std::string>& blocks, const std::string& indent);
  static std::string forever(const std::string& inside, const std::string& indent);

  /// The condition of the module, or, one time in `one_time_in`, of any.
  std::string condition(const Module& in, int one_time_in);
  const std::string& any_module() { return chance_.one_of(modules_).name; }
  /// "statement IN module" of one that was said.
  std::string at();

  /// REQUIREMENT r0, r1, … in the order in which they are added.
  class Requirements {
   public:
    void add(const std::string& measure) {
      text_ += "  REQUIREMENT r" + std::to_string(number_++) + " : " + measure + "\n";
    }
    const std::string& text() const { return text_; }

   private:
    std::string text_;
    int number_ = 0;
  };

  // The workcell.
  /// One to three of them. One in `one_nonpreemptive_in` is not preemptive.
  std::string processors(int one_nonpreemptive_in);
  std::string place(const std::string& thread, int priorities);
  /// Of some of the blocks of a CONCURRENT that have names of their own.
  std::string places_of_blocks(int priorities);
  std::string costs_and_latencies();

  Chance chance_;
  std::vector<Module> modules_;
  std::vector<std::string> messages_;
  std::vector<std::string> blocks_;
  std::vector<std::pair<std::string, std::string>> said_;  // module and statement

 private:
  int processors_ = 0;
};

}  // namespace pal::test
