// Statements taken out of a text and put elsewhere, with their lines.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pal/support/diagnostic.hpp"
#include "pal/syntax/tree.hpp"

namespace pal::rewrite {

/// `text`: of the file that all statements are in.
class Placing {
 public:
  explicit Placing(std::string_view text) : text_(text) {}

  std::string words(const syntax::Statement& statement) const;

  /// A line of its own before, or after, `place`, with the same indentation. `place` must be simple, or
  /// `words` come before it.
  Edit before(const syntax::Statement& place, const std::string& words) const;
  Edit after(const syntax::Statement& place, const std::string& words) const;
  /// With its line, if nothing else stands there.
  Edit without(const syntax::Statement& statement) const;
  Edit instead(const syntax::Statement& statement, const std::string& words) const;

 private:
  std::string indentation(std::size_t at) const;
  std::size_t line_begin(std::size_t at) const;
  /// Behind the line break, or the end of the text.
  std::size_t line_end(std::size_t at) const;

  std::string_view text_;
};

/// Calls `visit` with the list, and with each list in it: blocks, arms, loops.
template <class Visit>
void visit_lists(const syntax::Statements& list, const Visit& visit);

/// The lists that stand in a statement.
std::vector<const syntax::Statements*> lists_in(const syntax::Statement& statement);

template <class Visit>
void visit_lists(const syntax::Statements& list, const Visit& visit) {
  visit(list);
  for (const syntax::Statement& statement : list) {
    for (const syntax::Statements* inner : lists_in(statement)) visit_lists(*inner, visit);
  }
}

/// The modules of the file that have a body.
std::vector<const syntax::ModuleUnit*> modules_of(const syntax::Tree& tree);

/// Calls `visit` with each module of the file and each of its lists.
template <class Visit>
void visit_lists(const syntax::Tree& tree, const Visit& visit) {
  for (const syntax::ModuleUnit* module : modules_of(tree))
    visit_lists(module->body, [&](const syntax::Statements& list) { visit(*module, list); });
}

}  // namespace pal::rewrite
