#include "pal/syntax/dot/structure.hpp"

#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "pal/support/finding.hpp"
#include "pal/syntax/dot/ways.hpp"
#include "pal/syntax/dot/words.hpp"
#include "pal/syntax/parse.hpp"

namespace pal::syntax {

namespace {

class StructureReader {
 public:
  StructureReader(const DotGraph& graph, DotContents& contents, Diagnostics& diagnostics)
      : graph_(graph),
        contents_(contents),
        diagnostics_(diagnostics),
        ways_(graph, diagnostics),
        visited_(graph.nodes.size(), false) {
    for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
      if (const DotValue* number = graph.nodes[i].values.find("pal_node")) numbers_.emplace(number->text, i);
    }
  }

  Statements read() {
    const std::size_t start = only_start();
    visited_[start] = true;
    Statements body;
    const auto end = sequence(ways_.only(start), 0, body);
    if (end && kind(*end) != "end") {
      fail(*end, {Finding::ends_what_never_began});
    }
    if (end) visited_[*end] = true;
    find_unvisited();
    return body;
  }

 private:
  /// The node at which a sequence of statements ended: of a kind that ends what began before it. Nothing if
  /// the flow never gets to an end.
  using End = std::optional<std::size_t>;

  const std::string& kind(std::size_t i) const { return contents_.kinds[i]; }
  SourceSpan where(std::size_t i) const { return graph_.nodes[i].where; }

  [[noreturn]] void fail(std::size_t at, const PartialDiagnostic& what) {
    diagnostics_.report(what, where(at));
    throw Reported{};
  }

  std::size_t only_start() {
    std::optional<std::size_t> start;
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) {
      if (kind(i) != "start") continue;
      if (start) fail(i, {Finding::module_begins_twice});
      start = i;
    }
    if (start) return *start;
    diagnostics_.report(Finding::module_begins_nowhere, graph_.where);
    throw Reported{};
  }

  void find_unvisited() {
    constexpr int most = 20;
    int found = 0;
    for (std::size_t i = 0; i < graph_.nodes.size() && found < most; ++i) {
      if (visited_[i]) continue;
      ++found;
      diagnostics_.report(Finding::no_way_leads_to_node, where(i));
    }
  }

  void visit(std::size_t i) {
    if (visited_[i]) {
      fail(i, {Finding::two_ways_meet});
    }
    visited_[i] = true;
  }

  End sequence(std::size_t first, int depth, Statements& to) {
    if (depth > deepest_nesting) {
      diagnostics_.report(Finding::statements_nested_too_deeply, where(first), deepest_nesting);
      throw Reported{};
    }
    for (End next = first; next;) {
      const std::size_t at = *next;
      const std::string& word = kind(at);
      if (word == "end" || word == "merge" || word == "until" || word == "join") return at;
      visit(at);
      if (word == "guard") fail(at, {Finding::misplaced_guard});
      Statement statement = std::move(contents_.statements[at]);
      next = on_from(at, depth, statement);
      to.push_back(std::move(statement));
    }
    return std::nullopt;
  }

  /// Fills in what is inside of the statement at `at`; gives what follows it.
  End on_from(std::size_t at, int depth, Statement& statement) {
    const std::string& word = kind(at);
    if (word == "case") return choose(at, depth, statement);
    if (word == "repeat") return repeat(at, depth, statement);
    if (word == "concurrent") return concurrent(at, depth, statement);
    if (auto* wait = std::get_if<WaitBranches>(&statement.content)) return wait_branches(at, depth, *wait);
    // What ends the skill may be drawn as the end of everything.
    if (word == "complete" && ways_.none(at)) return std::nullopt;
    return ways_.only(at);
  }

  /// A branch of `split`; all that end must end in one node of the kind `together`.
  Statements branch(std::size_t split, std::size_t first, int depth, const std::string& together, End& all) {
    Statements body;
    const End end = sequence(first, depth + 1, body);
    if (!end) return body;
    if (kind(*end) != together || (all && *all != *end)) {
      auto& finding = diagnostics_.report(Finding::ways_do_not_meet, where(split), together);
      finding.note(where(*end), Remark::one_comes_here);
      if (all && *all != *end) finding.note(where(*all), Remark::another_here);
      throw Reported{};
    }
    all = end;
    return body;
  }

  End behind(End mate) {
    if (!mate) return std::nullopt;
    visit(*mate);
    return ways_.only(*mate);
  }

  End choose(std::size_t at, int depth, Statement& statement) {
    Choose result;
    End all;
    for (const std::size_t arm : ways_.branches(at)) {
      if (kind(arm) != "guard") fail(arm, {Finding::case_without_guard});
      visit(arm);
      Statements body = branch(at, ways_.only(arm), depth, "merge", all);
      result.arms.push_back({std::move(contents_.guards[arm].value()), std::move(body), where(arm)});
    }
    statement.content = std::move(result);
    return behind(all);
  }

  End wait_branches(std::size_t at, int depth, WaitBranches& wait) {
    const auto ways = ways_.branches(at);
    const std::size_t expected = wait.arms.size() + (wait.within ? 1 : 0);
    if (ways.size() != expected) {
      fail(at, ways.size() == 1 ? PartialDiagnostic(Finding::wait_has_one_way, expected)
                                : PartialDiagnostic(Finding::wait_has_ways, ways.size(), expected));
    }
    End all;
    for (std::size_t k = 0; k < ways.size(); ++k)
      (k < wait.arms.size() ? wait.arms[k].body : wait.otherwise) = branch(at, ways[k], depth, "merge", all);
    return behind(all);
  }

  End repeat(std::size_t at, int depth, Statement& statement) {
    Repeat result;
    const End end = sequence(ways_.only(at), depth + 1, result.body);
    if (!end || kind(*end) != "until") fail(at, {Finding::repeat_without_until});
    visit(*end);
    auto& guard = contents_.guards[*end];
    const End next = ways_.behind_loop(at, *end, !guard);
    result.until = std::move(guard);
    result.until_where = where(*end);
    statement.end = where(*end);
    statement.content = std::move(result);
    return next;
  }

  End concurrent(std::size_t at, int depth, Statement& statement) {
    Concurrent result;
    End all;
    for (const std::size_t block : ways_.branches(at))
      result.blocks.push_back({branch(at, block, depth, "join", all), where(at)});
    statement.content = std::move(result);
    if (!all) all = mate(at);
    if (!all || kind(*all) != "join") {
      fail(at, {Finding::concurrent_without_join});
    }
    return behind(all);
  }

  /// The node that pal_mate names; needed only where no way leads to it.
  End mate(std::size_t at) const {
    const DotValue* wanted = graph_.nodes[at].values.find("pal_mate");
    if (wanted == nullptr) return std::nullopt;
    const auto found = numbers_.find(wanted->text);
    return found == numbers_.end() ? std::nullopt : End(found->second);
  }

  const DotGraph& graph_;
  DotContents& contents_;
  Diagnostics& diagnostics_;
  DotWays ways_;
  std::vector<bool> visited_;
  std::unordered_map<std::string, std::size_t> numbers_;  // of pal_node
};

}  // namespace

Statements read_structure(const DotGraph& graph, DotContents& contents, Diagnostics& diagnostics) {
  return StructureReader(graph, contents, diagnostics).read();
}

}  // namespace pal::syntax
