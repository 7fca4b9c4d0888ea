// Facts about the things of a skill: a document has them as cells of tables, an editor shows them one by one.
#pragma once

#include <string>
#include <vector>

#include "pal/doc/document.hpp"
#include "pal/pan/network.hpp"

namespace pal::doc {

struct Fact {
  std::string head;  // "Content", "Set by"
  Line line;         // empty: there is nothing to say
};

/// In the order of the document's columns. The same thing has the same heads in every skill.
std::vector<Fact> facts_of(const pan::Network& network, pan::MessageId message);      // Content, Ways
std::vector<Fact> facts_of(const pan::Network& network, pan::ConditionId condition);  // Meaning, Set by, From
std::vector<Fact> facts_of(const pan::Network& network, pan::ActivityId activity);    // Module, Reads, Writes

/// The name of a module, its descriptions, and the devices that it drives.
Line line_of(const pan::Network& network, pan::ModuleId module);

}  // namespace pal::doc
