// Networks and environments as text: for people, for goldens, for `--emit=pan`.
#pragma once

#include <iosfwd>
#include <string>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"

namespace pal::pan {

/// One statement in its canonical spelling: "TXM( motion to MC1 )", "CASE", "UNTIL( pc-force OR pc-reach )".
/// Nodes that are no statement have the word that stands in the text ("END CASE"), or "start", "end".
std::string statement_text(const Network& network, ModuleId module, NodeId node);

/// A guard in its canonical spelling: "pc-force = TRUE", "pc-force OR pc-reach".
std::string guard_text(const Network& network, const Guard& guard);

/// "skill module", …
std::string kind_text(ModuleKind kind);

/// "REAL[255] mm": a type as it is declared. `size` is that of an array; 0: a single value.
std::string declared_type(ScalarType type, const std::string& unit, int size = 0);

/// The name of the module or device.
const std::string& party_name(const Network& network, const Party& party);

/// Everything that the value holds but its places in the text. The same value gives the same bytes.
void dump(const Network& network, std::ostream& out);
void dump(const Environment& environment, std::ostream& out);

}  // namespace pal::pan
