// Moves the setting of a condition behind the wait that brings its message.
#include <variant>

#include "pal/rewrite/placing.hpp"
#include "pal/rewrite/rewrite.hpp"

namespace pal::rewrite {
namespace {

using syntax::Statement;
using syntax::Statements;

const syntax::Set* set_of(const Statement& statement) {
  return std::get_if<syntax::Set>(&statement.content);
}

const syntax::Wait* wait_of(const Statement& statement) {
  return std::get_if<syntax::Wait>(&statement.content);
}

bool is_activity(const Statement& statement) {
  return std::holds_alternative<syntax::Perform>(statement.content);
}

bool asks_for(const Statement& statement, const syntax::Source& answer) {
  const auto* send = std::get_if<syntax::Send>(&statement.content);
  return send != nullptr && send->message.request && !answer.message.request &&
         send->message.name.text == answer.message.name.text && send->to.name.text == answer.from.name.text;
}

/// The sensing that ends just before `end`: a request if there is one, the wait for its answer, activities,
/// and what is set from it.
struct Sensing {
  const Statement* first = nullptr;  // null: there is none
  std::string conditions;            // "near, far"
};

Sensing sensing_before(const Statements& list, std::size_t end) {
  Sensing found;
  std::size_t begin = end;
  while (begin > 0 && (set_of(list[begin - 1]) != nullptr || is_activity(list[begin - 1]))) --begin;
  for (std::size_t i = begin; i < end; ++i) {
    const syntax::Set* set = set_of(list[i]);
    if (set != nullptr && !set->value)
      found.conditions += (found.conditions.empty() ? "" : ", ") + set->condition.text;
  }
  const syntax::Wait* answer = begin > 0 ? wait_of(list[begin - 1]) : nullptr;
  if (answer == nullptr || found.conditions.empty()) return {};
  const bool asked = begin > 1 && asks_for(list[begin - 2], answer->source);
  found.first = &list[asked ? begin - 2 : begin - 1];
  return found;
}

}  // namespace

std::vector<Rewriting> set_after_wait(const syntax::Tree& tree, std::string_view text) {
  const Placing placing(text);
  std::vector<Rewriting> found;
  visit_lists(tree, [&](const syntax::ModuleUnit& module, const Statements& list) {
    for (std::size_t i = 1; i < list.size(); ++i) {
      const syntax::Wait* wait = wait_of(list[i]);
      const Sensing sensing = wait == nullptr ? Sensing{} : sensing_before(list, i);
      if (sensing.first == nullptr) continue;
      const syntax::MessageName& message = wait->source.message;
      const std::string name = (message.request ? "request " : "") + message.name.text;
      found.push_back({"wait for " + name + " before sensing " + sensing.conditions,
                       module.name.text,
                       sensing.first->where,
                       {placing.before(*sensing.first, placing.words(list[i])), placing.without(list[i])}});
    }
  });
  return found;
}

}  // namespace pal::rewrite
