// Random skills in which many threads send and take one message.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/chance.hpp"

namespace pal::test {

/// A skill method and two controllers, each one loop or several blocks on processors of their own. Any block
/// sends any message of its module, and takes any, with limits and without. So several threads wait to send
/// one message, and several to take it. One wait may take the same message from two parties. Each controller
/// has a device. It has events at known phases, at unknown ones or sporadic, or answers, or frames. Most
/// periods are equal or multiples. Loops and blocks end early. The requirements are of each measure, about
/// statements that stand in the text. All times are whole milliseconds; the same seed gives the same text.
class ManyParties {
 public:
  explicit ManyParties(std::uint64_t seed) : chance_(seed) {}

  std::string text();

 private:
  using Lines = std::vector<std::string>;
  struct Asked {
    std::string device;
    std::string message;
    int kind = 0;
  };

  static std::string ms(int time) { return std::to_string(time) + " ms"; }

  /// Remembers a statement, for the requirements.
  std::string say(const std::string& statement);
  std::string send();
  std::string wait();
  std::string work() { return say(chance_.one_of({"work", "work", "rest"})); }
  std::string test() {
    return chance_.one_of({"c", "e", "NOT c", "c OR e", "e AND NOT f", "f", "NOT ( e OR c )"});
  }

  std::string little();

  std::string statement(int depth);
  std::string statements(int depth);
  std::string loop(const std::string& body, const std::string& until = "forever");

  std::string block(int depth);
  std::string blocks(int depth);

  void begin(const std::string& module, Lines sends, Lines waits, const std::string& sets);
  std::string rest_of();
  std::string finished(const std::string& head, const std::string& body);

  std::string controller(const std::string& name, Lines sends, const std::string& device,
                         const std::string& message, const std::string& sets);

  std::string method();

  std::string at();
  std::string put();
  std::string requirements();

  std::string times_of(const Asked& device);

  std::string environment();

  Chance chance_;
  int period_ = 2;
  bool loops_ = false;
  std::string module_;
  std::string sets_;
  int blocks_ = 0;
  Lines sends_, waits_, unsent_, untaken_, from_, places_;
  std::vector<Asked> devices_;
  std::vector<std::pair<std::string, std::string>> said_;  // module and statement
};

}  // namespace pal::test
