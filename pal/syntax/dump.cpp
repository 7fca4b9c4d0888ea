// A tree as text, for golden tests and --emit=tree.
#include <ostream>
#include <sstream>
#include <string>

#include "pal/support/duration_text.hpp"
#include "pal/syntax/print.hpp"

namespace pal::syntax {

namespace {

class Dumper {
 public:
  Dumper(const SourceManager& sources, std::ostream& out) : sources_(sources), out_(out) {}

  void file(const Tree& tree) {
    out_ << "file " << sources_.name(tree.file) << (tree.complete ? "" : " (incomplete)") << '\n';
    for (const auto& unit : tree.units) {
      if (const auto* module = std::get_if<ModuleUnit>(&unit)) {
        this->module(*module);
      } else {
        other(unit);
      }
    }
  }

 private:
  void line(std::size_t depth, const std::string& text, SourceSpan where) {
    out_ << std::string(2 * depth, ' ') << text;
    if (where.valid()) {
      const auto [row, column] = sources_.line_column(where.file, where.begin);
      out_ << "  @" << row << ':' << column;
    }
    out_ << '\n';
  }

  /// Units without statements: their lines as printed, and their place.
  void other(const Unit& unit) {
    Tree alone;
    alone.units.push_back(unit);
    std::ostringstream text;
    print(alone, text);
    std::istringstream lines(text.str());
    auto where = std::visit([](const auto& u) { return u.where; }, unit);
    for (std::string each; std::getline(lines, each);) {
      line(1, each, where);
      where = {};
    }
  }

  void module(const ModuleUnit& module) {
    line(1, title(module.kind) + ": " + module.name.text, module.where);
    for (const auto& activity : module.activities) {
      auto text = "ACTIVITY " + activity.name.text;
      for (const auto& name : activity.reads) text += " reads " + name.text;
      for (const auto& name : activity.writes) text += " writes " + name.text;
      if (activity.time) text += " time " + to_text(*activity.time);
      line(2, text, activity.where);
    }
    if (module.has_body) statements(2, module.body);
  }

  void statements(std::size_t depth, const Statements& list) {
    for (const auto& statement : list) {
      line(depth, head(statement), statement.where);
      std::visit([&](const auto& content) { rest(depth + 1, content); }, statement.content);
    }
  }

  template <class Simple>
  void rest(std::size_t, const Simple&) {}

  void rest(std::size_t depth, const WaitBranches& wait) {
    for (const auto& arm : wait.arms) {
      line(depth, spelling(arm.source.message) + " from " + spelling(arm.source.from), arm.where);
      statements(depth + 1, arm.body);
    }
    if (!wait.within) return;
    line(depth, "else", {});
    statements(depth + 1, wait.otherwise);
  }

  void rest(std::size_t depth, const Choose& choose) {
    for (const auto& arm : choose.arms) {
      line(depth, "( " + spelling(arm.guard) + " )", arm.where);
      statements(depth + 1, arm.body);
    }
  }

  void rest(std::size_t depth, const Repeat& repeat) {
    statements(depth, repeat.body);
    line(depth, "until " + (repeat.until ? spelling(*repeat.until) : "forever"), repeat.until_where);
  }

  void rest(std::size_t depth, const Concurrent& concurrent) {
    for (const auto& block : concurrent.blocks) {
      line(depth, "block", block.where);
      statements(depth + 1, block.body);
    }
  }

  const SourceManager& sources_;
  std::ostream& out_;
};

}  // namespace

void dump(const Tree& tree, const SourceManager& sources, std::ostream& out) {
  Dumper(sources, out).file(tree);
}

}  // namespace pal::syntax
