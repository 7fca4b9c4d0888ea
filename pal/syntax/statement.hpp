// The statements of PAL as they were written.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "pal/pan/network.hpp"
#include "pal/support/source.hpp"
#include "pal/support/time.hpp"

namespace pal::syntax {

struct Name {
  std::string text;
  SourceSpan where;
};

/// `request X` and `X request` are the same: the request for X.
struct MessageName {
  bool request = false;
  Name name;
  SourceSpan where;
};

/// `MC1`, or `machine controller MC1`.
struct PartyName {
  std::optional<pan::ModuleKind> kind;
  Name name;
  SourceSpan where;
};

struct Guard {
  enum class Kind { equals, all_of, any_of, negation };
  Kind kind = Kind::equals;
  Name condition;
  bool value = true;
  std::vector<Guard> terms;
};

struct Statement;
using Statements = std::vector<Statement>;

struct WaitForStart {};

struct Source {
  MessageName message;
  PartyName from;
};
/// WTM( X from M )
struct Wait {
  Source source;
};
struct WaitArm {
  Source source;
  Statements body;
  SourceSpan where;
};
/// WTM( X from M ) WITHIN … ELSE … END WTM: one arm and not `first`. WTM FIRST …: any number of arms.
struct WaitBranches {
  bool first = false;
  std::vector<WaitArm> arms;
  std::optional<Duration> within;  // if and only if there is an ELSE
  Statements otherwise;
};
/// TXM( X to M ); TXM( request X from M ) sends the message `request X` to M.
struct Send {
  MessageName message;
  PartyName to;
};
struct Complete {
  int code = 0;
  SourceSpan code_where;
};
struct Set {
  Name condition;
  std::optional<bool> value;
};
struct Read {
  Name condition;
};
struct Arm {
  Guard guard;
  Statements body;
  SourceSpan where;  // the guard
};
struct Choose {
  std::vector<Arm> arms;
};
/// REPEAT … UNTIL( … ); without a guard: forever.
struct Repeat {
  Statements body;
  std::optional<Guard> until;
  SourceSpan until_where;
};
struct Block {
  Statements body;
  SourceSpan where;  // its BEGIN
};
struct Concurrent {
  std::vector<Block> blocks;
};
struct Execute {
  PartyName module;
};
struct Nothing {};
/// A bare name: an activity, or a module to execute.
struct Perform {
  Name name;
};

struct Statement {
  std::variant<WaitForStart, Wait, WaitBranches, Send, Complete, Set, Read, Choose, Repeat, Concurrent,
               Execute, Nothing, Perform>
      content;
  /// A simple statement: all of it. Others: their first line (`WTM( X from M ) WITHIN 4 ms`, `CASE`,
  /// `REPEAT`).
  SourceSpan where;
  SourceSpan end;  // of those that have one: `END CASE`, `UNTIL( … )`, …
};

}  // namespace pal::syntax
