// Moves a request to a sensor ahead of the wait for the robot.
#include <algorithm>
#include <optional>

#include "pal/rewrite/placing.hpp"
#include "pal/rewrite/rewrite.hpp"

namespace pal::rewrite {
namespace {

using syntax::Statement;
using syntax::Statements;

/// The statement that takes what `send` asks for.
bool answers(const Statement& statement, const syntax::Send& send) {
  const auto* wait = std::get_if<syntax::Wait>(&statement.content);
  return wait != nullptr && !wait->source.message.request &&
         wait->source.message.name.text == send.message.name.text &&
         wait->source.from.name.text == send.to.name.text;
}

bool is_same_request(const Statement& statement, const syntax::Send& send) {
  const auto* other = std::get_if<syntax::Send>(&statement.content);
  return other != nullptr && other->message.request && other->message.name.text == send.message.name.text &&
         other->to.name.text == send.to.name.text;
}

/// How often a statement like this is in the list, or in lists in it.
template <class Like>
std::size_t count(const Statements& body, const Like& like) {
  std::size_t found = 0;
  visit_lists(body, [&](const Statements& list) {
    found += static_cast<std::size_t>(std::count_if(list.begin(), list.end(), like));
  });
  return found;
}

/// Of the loop `repeat`: each request that it alone sends in each of its rounds, before it takes the answer.
void look(const syntax::ModuleUnit& module, const Statement& repeat, const Placing& placing,
          std::vector<Rewriting>& found) {
  const Statements& body = std::get<syntax::Repeat>(repeat.content).body;
  for (std::size_t i = 0; i < body.size(); ++i) {
    const auto* send = std::get_if<syntax::Send>(&body[i].content);
    if (send == nullptr || !send->message.request) continue;
    const auto answer = std::find_if(body.begin() + static_cast<std::ptrdiff_t>(i) + 1, body.end(),
                                     [&](const Statement& each) { return answers(each, *send); });
    if (answer == body.end()) continue;
    if (count(body, [&](const Statement& each) { return is_same_request(each, *send); }) != 1) continue;
    if (count(body, [&](const Statement& each) { return answers(each, *send); }) != 1) continue;
    const std::string words = placing.words(body[i]);
    found.push_back(
        {"ask " + send->to.name.text + " for the next " + send->message.name.text +
             " as soon as the last one is there (a courier)",
         module.name.text,
         body[i].where,
         {placing.before(repeat, words), placing.without(body[i]), placing.after(*answer, words)}});
  }
}

}  // namespace

std::vector<Rewriting> ask_ahead(const syntax::Tree& tree, std::string_view text) {
  const Placing placing(text);
  std::vector<Rewriting> found;
  visit_lists(tree, [&](const syntax::ModuleUnit& module, const Statements& list) {
    for (const Statement& statement : list) {
      if (std::holds_alternative<syntax::Repeat>(statement.content)) look(module, statement, placing, found);
    }
  });
  return found;
}

}  // namespace pal::rewrite
