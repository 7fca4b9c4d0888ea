// Random skills whose modules take, ask and send in blocks within blocks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/chance.hpp"

namespace pal::test {

/// Four to six modules with one loop each, on one to three processors. One message begins the rounds of a
/// module. What else the module takes, asks for and sends stands anywhere in its round, or before. It may
/// stand in branches, with limits, in several places at once, and in blocks within blocks. The blocks end, go
/// round until a condition holds, or are cancelled in the middle. The method completes with several codes, in
/// the middle of its rounds and of its blocks. The same seed gives the same text.
class NestedSkill {
 public:
  explicit NestedSkill(std::uint64_t seed) : chance_(seed) {
    for (int& each : odd_) each = chance_(8);
  }

  std::string text();

 private:
  /// Something that a module must say somewhere.
  struct Item {
    enum class Kind { take, call, send };
    Kind kind = Kind::send;
    std::string message;
    std::string party;
    bool answered = false;  // take: of a request
  };
  using Items = std::vector<Item>;
  struct Module {
    std::string kind;
    std::string name;
    Items items;
  };
  enum class Odd { blocks, limits, loops, twice, branches, endings, before, middle, gives_up, commands };

  /// Of what is odd only some is in one skill, so that something is bounded.
  bool odd(Odd what, int one_in) { return odd_[static_cast<std::size_t>(what)] == 0 && chance_(one_in) == 0; }
  static std::string upper(std::string text);

  Module& module(const std::string& name);
  void serves(const std::string& server, const std::string& client, const std::string& message);
  void sends(const std::string& from, const std::string& to, const std::string& message);
  void takes(const std::string& name, const std::string& message, const std::string& device);

  void draw();

  std::string say(const Module& in, const std::string& statement, const std::string& indent);
  std::string work(const Module& in, const std::string& indent);
  std::string any_module();
  /// Takes no message, and sends none.
  std::string small(const Module& in, const std::string& indent);
  std::string smalls(const Module& in, int most, const std::string& indent);
  std::string choice(const Module& in, const std::string& yes, const std::string& no,
                     const std::string& indent);
  std::string wait(const Module& in, const std::string& message, const std::string& then,
                   const std::string& indent);

  /// An item, once.
  std::string once(const Module& in, const Item& item, const std::string& indent);

  /// Once, or again and again. `last`: nothing comes after it in its block.
  std::string leaf(const Module& in, const Item& item, bool last, const std::string& indent);

  std::string complete(const Module& in, const std::string& indent);

  /// All items, in some order and form.
  std::string tree(const Module& in, Items items, int depth, bool last, const std::string& indent);

  static std::string wait_of(const Item& take);

  /// Rounds that begin with `main`, if that is something, and say all items; of the method perhaps one only.
  std::string loop(const Module& in, const Item* main, Items items, const std::string& indent);

  /// What begins the rounds of a module is taken before them, too.
  std::string before(const Module& in, const Item& take);

  std::string body(const Module& in);

  std::string at();

  std::string requirements();

  std::string interval(int low, int high);

  std::string environment();

  Chance chance_;
  bool tack_ = false;   // there is a device that sends it
  bool value_ = false;  // there is one that is asked for it
  int odd_[10] = {};    // by Odd; 0: it is
  std::vector<Module> modules_;
  std::vector<std::string> messages_;
  std::vector<std::string> blocks_;
  std::vector<std::pair<std::string, std::string>> said_;  // module and statement
};

}  // namespace pal::test
