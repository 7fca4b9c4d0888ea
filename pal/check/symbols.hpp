// Every name of a set of files: where it is declared, and each place that uses it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pal/support/source.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::check {

enum class SymbolKind : std::uint8_t {
  skill,
  module,
  device,
  message,
  field,
  condition,
  activity,
  parameter,
  requirement,
  contingency,
  completion,
  environment,
  processor
};

/// A declaration. Contingencies and completions are named by their numbers.
struct Symbol {
  SymbolKind kind = SymbolKind::module;
  std::string name;
  SourceSpan name_where;
  SourceSpan where;   // all of the declaration; of a module its body, too
  std::string owner;  // activity: its module; field: its message; of a template or an environment: its unit
};

/// read: WTM of a message, RPC and tests of a condition, READS. write: TXM, SPC, WRITES.
enum class UseRole : std::uint8_t { declaration, mention, read, write };

/// A place where the name of `symbol` stands. One place may have several: a module's file that two skills use
/// may mean another declaration in each.
struct Use {
  SourceSpan where;
  std::size_t symbol = 0;
  UseRole role = UseRole::mention;
};

struct Symbols {
  std::vector<Symbol> all;
  std::vector<Use> uses;  // with the declarations; by file and place

  /// The uses at byte `offset` of `file`; also at the end of the name.
  std::vector<const Use*> at(FileId file, std::uint32_t offset) const;
};

/// Looks up every name of `trees`, as check() does but without findings, also in trees that are not complete.
/// Each tree with a skill, and each that no other uses, sees its own declarations and those of the trees that
/// it uses. An environment's names mean the declarations of all trees. Names that mean nothing are left out.
/// Contract: Uses::file is filled in.
Symbols symbols_of(const std::vector<syntax::Tree>& trees);

/// "skill", "module", …
const char* name(SymbolKind kind);

}  // namespace pal::check
