// A tree as text again.
#pragma once

#include <iosfwd>
#include <string>

#include "pal/support/source.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::syntax {

/// Canonical PAL, in the layout of format(), times in the greatest unit that fits. Parsing it gives the same
/// program; printing that gives the same text. A tree has no comments, so neither has this.
/// Of a tree that is not complete: the words that it has.
void print(const Tree& tree, std::ostream& out);

/// Every node of the tree on a line of its own, with its place as line:column. For tests and `--emit=tree`.
void dump(const Tree& tree, const SourceManager& sources, std::ostream& out);

/// One statement without its branches, in canonical spelling: "WTM( X from M ) WITHIN 4 ms", "CASE".
std::string head(const Statement& statement);

/// "X", "request X"; "MC1", "machine controller MC1"; "pc-force OR pc-reach".
std::string spelling(const MessageName& message);
std::string spelling(const PartyName& party);
std::string spelling(const Guard& guard);

/// "Skill Module", as a module is declared.
std::string title(pan::ModuleKind kind);

}  // namespace pal::syntax
