// Statements as capital letters and conditions as c1, c2, …, as in the thesis.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "pal/pan/network.hpp"

namespace pal::pan {

/// Gives out "A", "B", …, "Z", "AA", … and "c1", "c2", … in the order of the text; one text has one letter.
class DotLetters {
 public:
  DotLetters(const Network& network, ModuleId module);

  /// The letter of a statement.
  std::string letter(const std::string& statement) const;
  /// A guard with short names: "c1", "not c1", "c1 or c2".
  std::string guard(const Guard& guard) const;

  /// Letters and conditions with what they stand for, below `title`. It is a table in Graphviz' HTML with so
  /// many columns, or more if it would be long. `signs`: rows of a table that stands below; may be empty.
  std::string key(const std::string& title, std::size_t columns, const std::string& signs) const;

 private:
  void meet(const Guard& guard);
  void meet(ConditionId condition);

  const Network& network_;
  std::vector<std::pair<std::string, std::string>> statements_;
  std::vector<std::pair<std::string, std::string>> conditions_;
};

}  // namespace pal::pan
