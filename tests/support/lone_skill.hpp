// Skills whose method talks with devices only.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "tests/support/chance.hpp"

namespace pal::test {

/// The method is one sequence, or blocks with a sequence each. It asks sensors that are devices, reads
/// conditions that controllers set by events, and sets conditions that a controller reads. One list has what
/// it may do before its rounds, in them, in rounds that end the skill, and after them. No module keeps it
/// waiting, so most of its requirements have bounds. The same seed gives the same text.
class LoneSkill {
 public:
  explicit LoneSkill(std::uint64_t seed);

  std::string text();

 private:
  std::string ask(int which);
  std::string thing();
  std::string things(int least, int most);
  std::string ending();
  std::string round();
  std::string life(const std::string& condition);
  std::string method();
  std::string controllers() const;
  std::string requirements(const std::string& method) const;
  std::string environment();

  Chance chance_;
  int blocks_;   // of the method; 0: none
  int clocks_;   // controllers with a clock each, which sets a condition
  bool reader_;  // of what the method sets
  int own_ = 1;  // the sensor that each round asks; the two after it are asked anywhere
  std::set<int> asked_;
};

}  // namespace pal::test
