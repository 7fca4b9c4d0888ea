#include "pal/rewrite/placing.hpp"

#include <cassert>
#include <variant>

namespace pal::rewrite {

std::string Placing::words(const syntax::Statement& statement) const {
  assert(statement.where.valid() && statement.where.end <= text_.size());
  return std::string(text_.substr(statement.where.begin, statement.where.end - statement.where.begin));
}

std::size_t Placing::line_begin(std::size_t at) const {
  const auto before = text_.substr(0, at).rfind('\n');
  return before == std::string_view::npos ? 0 : before + 1;
}

std::size_t Placing::line_end(std::size_t at) const {
  const auto next = text_.find('\n', at);
  return next == std::string_view::npos ? text_.size() : next + 1;
}

std::string Placing::indentation(std::size_t at) const {
  const std::string_view line = text_.substr(line_begin(at));
  return std::string(line.substr(0, line.find_first_not_of(" \t")));
}

Edit Placing::before(const syntax::Statement& place, const std::string& words) const {
  const std::uint32_t at = place.where.begin;
  return {{place.where.file, at, at}, words + "\n" + indentation(at)};
}

Edit Placing::after(const syntax::Statement& place, const std::string& words) const {
  // A comment behind the statement stays with it.
  const std::size_t end = line_end(place.where.end);
  const auto at = static_cast<std::uint32_t>(end > 0 && text_[end - 1] == '\n' ? end - 1 : end);
  return {{place.where.file, at, at}, "\n" + indentation(place.where.begin) + words};
}

Edit Placing::without(const syntax::Statement& statement) const {
  const std::size_t begin = line_begin(statement.where.begin);
  const std::size_t end = line_end(statement.where.end);
  const auto blank = [this](std::size_t from, std::size_t to) {
    return text_.substr(from, to - from).find_first_not_of(" \t\r\n") == std::string_view::npos;
  };
  if (!blank(begin, statement.where.begin) || !blank(statement.where.end, end)) return {statement.where, ""};
  return {{statement.where.file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)}, ""};
}

Edit Placing::instead(const syntax::Statement& statement, const std::string& words) const {
  return {statement.where, words};
}

std::vector<const syntax::Statements*> lists_in(const syntax::Statement& statement) {
  std::vector<const syntax::Statements*> lists;
  if (const auto* wait = std::get_if<syntax::WaitBranches>(&statement.content)) {
    for (const syntax::WaitArm& arm : wait->arms) lists.push_back(&arm.body);
    lists.push_back(&wait->otherwise);
  } else if (const auto* choose = std::get_if<syntax::Choose>(&statement.content)) {
    for (const syntax::Arm& arm : choose->arms) lists.push_back(&arm.body);
  } else if (const auto* repeat = std::get_if<syntax::Repeat>(&statement.content)) {
    lists.push_back(&repeat->body);
  } else if (const auto* concurrent = std::get_if<syntax::Concurrent>(&statement.content)) {
    for (const syntax::Block& block : concurrent->blocks) lists.push_back(&block.body);
  }
  return lists;
}

std::vector<const syntax::ModuleUnit*> modules_of(const syntax::Tree& tree) {
  std::vector<const syntax::ModuleUnit*> modules;
  for (const syntax::Unit& unit : tree.units) {
    const auto* module = std::get_if<syntax::ModuleUnit>(&unit);
    if (module != nullptr && module->has_body) modules.push_back(module);
  }
  return modules;
}

}  // namespace pal::rewrite
