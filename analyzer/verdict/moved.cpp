#include "analyzer/verdict/moved.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace pal::analyzer {
namespace {

/// Which line became which.
class Lines {
 public:
  /// False: the statements or loops are others.
  bool learn(const Problem& from, const Problem& to) {
    if (from.statements.size() != to.statements.size() || from.loops.size() != to.loops.size()) return false;
    for (const StatementId s : from.statements.ids()) {
      const Statement& before = from.statements[s];
      const Statement& now = to.statements[s];
      if (before.text != now.text || before.module != now.module) return false;
      if (!add(before.file, before.line, now.file, now.line)) return false;
    }
    for (const LoopId loop : from.loops.ids()) {
      const ProgramLoop& before = from.loops[loop];
      const ProgramLoop& now = to.loops[loop];
      if (!add(before.file, before.line, now.file, now.line)) return false;
    }
    return true;
  }

  bool none_moved() const { return !moved_; }

  /// False: it is not known what became of the line.
  bool apply(const std::string& file, int& line) const {
    if (line == 0) return true;
    const auto found = by_file_.find({file, line});
    if (found == by_file_.end()) return false;
    line = found->second;
    return true;
  }

 private:
  bool add(const std::string& file, int line, const std::string& now_file, int now) {
    if (file != now_file || (line == 0) != (now == 0)) return false;
    if (line == 0) return true;
    moved_ = moved_ || line != now;
    const auto [of_file, first] = by_file_.try_emplace({file, line}, now);
    return of_file->second == now;  // two statements of one line are still in one line
  }

  bool moved_ = false;
  std::map<std::pair<std::string, int>, int> by_file_;
};

/// Reasons, or addends.
template <class Part>
bool move_all(std::vector<Part>& parts, const Lines& lines) {
  return std::all_of(parts.begin(), parts.end(), [&](Part& part) {
    return lines.apply(part.file, part.line) && move_all(part.inside, lines);
  });
}

bool move_run(Witness& witness, const Lines& lines) {
  auto& statements = witness.trace.statements;
  return std::all_of(statements.begin(), statements.end(),
                     [&](trace::Statement& each) { return lines.apply(each.file, each.line); });
}

}  // namespace

std::optional<Verdict> moved(const Verdict& verdict, const Problem& from, const Problem& to) {
  Lines lines;
  if (!lines.learn(from, to)) return std::nullopt;
  Verdict made = verdict;
  if (lines.none_moved()) return made;
  const auto explanation = made.explanation.with_lines(
      [&lines](const std::string& file, int& line) { return lines.apply(file, line); });
  if (!explanation || !move_all(made.reasons, lines) || !move_all(made.addends, lines)) return std::nullopt;
  made.explanation = *explanation;
  if (made.witness && !move_run(*made.witness, lines)) return std::nullopt;
  if (made.loop_growth && !move_run(made.loop_growth->first_turns, lines)) return std::nullopt;
  return made;
}

}  // namespace pal::analyzer
