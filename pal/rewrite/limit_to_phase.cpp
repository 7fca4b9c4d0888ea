// Limits a requirement to a phase.
#include <variant>

#include "pal/rewrite/rewrite.hpp"

namespace pal::rewrite {

std::vector<Rewriting> limit_to_phase(const syntax::Tree& tree, const std::string& skill,
                                      const std::map<std::string, std::string>& phases) {
  std::vector<Rewriting> found;
  for (const syntax::Unit& unit : tree.units) {
    const auto* head = std::get_if<syntax::SkillUnit>(&unit);
    if (head == nullptr || head->name.text != skill) continue;
    for (const syntax::Requirement& requirement : head->requirements) {
      const auto phase = phases.find(requirement.name.text);
      if (phase == phases.end() || requirement.phase) continue;
      const SourceSpan end{requirement.where.file, requirement.where.end, requirement.where.end};
      found.push_back({"require " + requirement.name.text + " only " + phase->second,
                       "",
                       requirement.where,
                       {{end, " " + phase->second}}});
    }
  }
  return found;
}

}  // namespace pal::rewrite
