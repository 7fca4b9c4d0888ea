// A run into a dead end, in words: what each thread does, and where each waits in the end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pal/check/deadlock/explore.hpp"
#include "pal/pan/network.hpp"

namespace pal::check::deadlock {

/// One line of the run, with its place.
struct Line {
  std::string thread;  // "SM1.2"
  std::string text;    // "sends motion to MC1"
  SourceSpan where;
  Action::Kind kind = Action::Kind::spins;
  std::size_t lane = 0;                   // thread's number in Automata
  std::optional<pan::ChannelId> channel;  // takes, sends, discards
};

struct StuckLine {
  std::string thread;
  std::string text;  // "waits for Zforce from LS1"
  SourceSpan where;
  std::size_t lane = 0;
  bool culprit = false;
};

/// A dead end, in words.
struct Story {
  bool total = false;
  bool timely = false;
  std::vector<std::string> lanes;             // the names of all threads, by number
  std::vector<pan::ModuleId> modules;         // … and whose they are
  std::optional<pan::ChannelId> undelivered;  // the command that is lost, if the run ends with the completion
  std::vector<Line> run;
  std::vector<StuckLine> stuck;
  std::string hint;
};

Story tell(const pan::Network& network, const Automata& automata, const DeadEnd& end);

/// A run that ends with the completion; no thread is stuck.
Story tell(const pan::Network& network, const Automata& automata, const Undelivered& undelivered);

}  // namespace pal::check::deadlock
