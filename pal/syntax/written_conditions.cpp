#include "pal/syntax/written_conditions.hpp"

#include <string_view>
#include <variant>

namespace pal::syntax {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// What stands between the first and the last parenthesis, with one blank where there are several.
std::string condition_inside(std::string_view text) {
  const auto left = text.find('(');
  const auto right = text.rfind(')');
  if (left == std::string_view::npos || right == std::string_view::npos || right < left) return {};
  text = text.substr(left + 1, right - left - 1);
  if (text.find('#') != std::string_view::npos) return {};
  std::string result;
  while (true) {
    const auto begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return result;
    text.remove_prefix(begin);
    const auto word = text.substr(0, text.find_first_of(blanks));
    result += (result.empty() ? "" : " ") + std::string(word);
    text.remove_prefix(word.size());
  }
}

class Collector {
 public:
  Collector(const SourceManager& sources, WrittenConditions& to) : sources_(sources), to_(to) {}

  void add(const Statements& statements) {
    for (const Statement& statement : statements)
      std::visit([&](const auto& content) { add(content, statement); }, statement.content);
  }

 private:
  template <class Other>
  void add(const Other&, const Statement&) {}  // has no condition and no statements inside

  void add(const WaitBranches& wait, const Statement&) {
    for (const WaitArm& arm : wait.arms) add(arm.body);
    add(wait.otherwise);
  }

  void add(const Choose& choose, const Statement& statement) {
    std::vector<std::string> arms;
    for (const Arm& arm : choose.arms) {
      arms.push_back(condition_inside(sources_.text(arm.where)));
      add(arm.body);
    }
    to_[{statement.where.file, statement.where.begin}] = std::move(arms);
  }

  void add(const Repeat& repeat, const Statement&) {
    add(repeat.body);
    if (!repeat.until) return;
    to_[{repeat.until_where.file, repeat.until_where.begin}] = {
        condition_inside(sources_.text(repeat.until_where))};
  }

  void add(const Concurrent& concurrent, const Statement&) {
    for (const Block& block : concurrent.blocks) add(block.body);
  }

  const SourceManager& sources_;
  WrittenConditions& to_;
};

}  // namespace

void add_written_conditions(const Tree& tree, const SourceManager& sources, WrittenConditions& to) {
  Collector collector(sources, to);
  for (const Unit& unit : tree.units) {
    if (const auto* module = std::get_if<ModuleUnit>(&unit)) collector.add(module->body);
  }
}

}  // namespace pal::syntax
