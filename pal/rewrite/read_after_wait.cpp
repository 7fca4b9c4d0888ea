// Moves the reading of a condition behind the wait before it.
#include <algorithm>
#include <optional>

#include "pal/rewrite/placing.hpp"
#include "pal/rewrite/rewrite.hpp"

namespace pal::rewrite {
namespace {

using syntax::Statement;
using syntax::Statements;

bool is_read(const Statement& statement) {
  return std::holds_alternative<syntax::Read>(statement.content);
}

const syntax::Source* source_of(const Statement& statement) {
  const auto* wait = std::get_if<syntax::Wait>(&statement.content);
  return wait == nullptr ? nullptr : &wait->source;
}

bool same(const syntax::Source& a, const syntax::Source& b) {
  return a.message.request == b.message.request && a.message.name.text == b.message.name.text &&
         a.from.name.text == b.from.name.text;
}

/// The waits with which arms of the CASE begin, if all of them are for the same.
std::vector<const Statement*> first_waits(const syntax::Choose& choose) {
  std::vector<const Statement*> waits;
  for (const syntax::Arm& arm : choose.arms) {
    const syntax::Source* source = arm.body.empty() ? nullptr : source_of(arm.body.front());
    if (source == nullptr) continue;
    if (!waits.empty() && !same(*source, *source_of(*waits.front()))) return {};
    waits.push_back(&arm.body.front());
  }
  return waits;
}

std::string conditions(const syntax::Guard& guard) {
  if (guard.kind == syntax::Guard::Kind::equals) return guard.condition.text;
  std::string all;
  for (const syntax::Guard& term : guard.terms) {
    const std::string name = conditions(term);
    if (all.find(name) == std::string::npos) all += (all.empty() ? "" : ", ") + name;
  }
  return all;
}

/// What is read by the statements from `first` up to `last`, the one before the wait.
std::string read_there(const Statements& list, std::size_t first, std::size_t last) {
  std::string all;
  for (std::size_t i = first; i <= last; ++i) {
    if (const auto* read = std::get_if<syntax::Read>(&list[i].content))
      all += (all.empty() ? "" : ", ") + read->condition.text;
  }
  if (!all.empty()) return all;
  const auto* choose = std::get_if<syntax::Choose>(&list[last].content);
  return choose == nullptr || choose->arms.empty() ? "" : conditions(choose->arms.front().guard);
}

class Finder {
 public:
  Finder(const syntax::ModuleUnit& module, std::string_view text, std::vector<Rewriting>& found)
      : module_(module), placing_(text), found_(found) {}

  /// Reads that follow each other, or a test without one, from `first` on.
  void look(const Statements& list, std::size_t first) {
    std::size_t next = first;
    while (next < list.size() && is_read(list[next])) ++next;
    if (next == list.size()) return;
    if (source_of(list[next]) != nullptr && next > first) move(list, first, next - 1, {&list[next]}, false);
    const auto* choose = std::get_if<syntax::Choose>(&list[next].content);
    if (choose != nullptr) move(list, first, next, first_waits(*choose), true);
  }

 private:
  /// `waits` come before the statement `first`.
  void move(const Statements& list, std::size_t first, std::size_t last,
            const std::vector<const Statement*>& waits, bool from_arms) {
    if (waits.empty()) return;
    const syntax::Source& source = *source_of(*waits.front());
    Rewriting made;
    made.title = "wait for " + std::string(source.message.request ? "request " : "") +
                 source.message.name.text + " before reading " + read_there(list, first, last);
    made.module = module_.name.text;
    made.where = list[first].where;
    made.edits.push_back(placing_.before(list[first], placing_.words(*waits.front())));
    const auto* choose = std::get_if<syntax::Choose>(&list[last].content);
    for (const Statement* wait : waits) {
      const bool alone =
          from_arms && std::any_of(choose->arms.begin(), choose->arms.end(), [&](const auto& arm) {
            return arm.body.size() == 1 && &arm.body.front() == wait;
          });
      made.edits.push_back(alone ? placing_.instead(*wait, "Do Nothing") : placing_.without(*wait));
    }
    found_.push_back(std::move(made));
  }

  const syntax::ModuleUnit& module_;
  Placing placing_;
  std::vector<Rewriting>& found_;
};

}  // namespace

std::vector<Rewriting> read_after_wait(const syntax::Tree& tree, std::string_view text) {
  std::vector<Rewriting> found;
  visit_lists(tree, [&](const syntax::ModuleUnit& module, const Statements& list) {
    Finder finder(module, text, found);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const bool begins = i == 0 || !is_read(list[i - 1]);
      const bool tests = std::holds_alternative<syntax::Choose>(list[i].content);
      if (begins && (tests || is_read(list[i]))) finder.look(list, i);
    }
  });
  return found;
}

}  // namespace pal::rewrite
