#include "pal/check/check.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "pal/check/network/build_network.hpp"
#include "pal/check/network/environment.hpp"
#include "pal/check/network/scope.hpp"
#include "pal/check/report.hpp"
#include "pal/check/rules/families.hpp"
#include "pal/check/rules/unused.hpp"
#include "pal/pan/flow.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

class Checker {
 public:
  Checker(const std::vector<syntax::Tree>& trees, Diagnostics& diagnostics, const std::function<bool()>& stop,
          Depth depth)
      : trees_(trees), diagnostics_(diagnostics), stop_(stop), depth_(depth) {}

  Specification check() {
    find_twice();
    for (std::size_t i = 0; i < trees_.size(); ++i) check_units(i);
    for (std::size_t i = 0; i < trees_.size(); ++i) check_leftovers(i);
    for (std::size_t i = 0; i < trees_.size(); ++i) check_unused(i);
    return std::move(result_);
  }

 private:
  void check_units(std::size_t index) {
    for (const auto& unit : trees_[index].units) {
      if (const auto* environment = std::get_if<syntax::EnvironmentUnit>(&unit)) {
        once(environments_, "environment", index, environment->name);
        result_.environments.push_back(check::build_environment(*environment, diagnostics_));
      } else if (const auto* skill = std::get_if<syntax::SkillUnit>(&unit)) {
        const bool first = once(skills_, "skill", index, skill->name);
        // Of two skills of one name it is unknown which is meant.
        if (first && !twice_.contains(skill->name.text)) {
          check_skill(index, *skill);
        } else {
          used_.insert(index);
        }
      }
    }
  }

  void find_twice() {
    std::map<std::string, std::vector<std::size_t>> declared;
    for (std::size_t i = 0; i < trees_.size(); ++i) {
      for (const auto& unit : trees_[i].units) {
        const auto* skill = std::get_if<syntax::SkillUnit>(&unit);
        if (skill == nullptr) continue;
        std::vector<std::size_t>& before = declared[skill->name.text];
        if (std::any_of(before.begin(), before.end(), [&](std::size_t other) { return meet(i, other); }))
          twice_.insert(skill->name.text);
        before.push_back(i);
      }
    }
  }

  /// The files that a file sees, itself included.
  const std::set<std::size_t>& seen_from(std::size_t index) {
    const auto [place, fresh] = seen_from_.try_emplace(index);
    if (fresh) {
      Diagnostics ignored;
      const auto scope = check::scope_of(trees_, index, ignored);
      place->second.insert(scope.trees.begin(), scope.trees.end());
    }
    return place->second;
  }

  /// Whether one of the files sees the other. Otherwise they may use the same names.
  bool meet(std::size_t one, std::size_t other) {
    return seen_from(one).contains(other) || seen_from(other).contains(one);
  }

  using Declared = std::map<std::string, std::vector<std::pair<std::size_t, const syntax::Name*>>>;

  /// False, and reported, if there is one of this name already where both are seen.
  bool once(Declared& declared, const char* what, std::size_t index, const syntax::Name& name) {
    auto& before = declared[name.text];
    const auto found = std::find_if(before.begin(), before.end(),
                                    [&](const auto& other) { return meet(index, other.first); });
    if (found != before.end()) check::report_twice(diagnostics_, what, name, *found->second);
    const bool first = found == before.end();
    before.emplace_back(index, &name);
    return first;
  }

  bool complete(const check::Scope& scope) const {
    for (const auto tree : scope.trees) {
      if (!trees_[tree].complete) return false;
    }
    return true;
  }

  /// Names that are declared nowhere, in files with syntax errors. A declaration without its name, or one on
  /// a line that was left out, may be that of any of them: then nothing is said.
  void look_up_names(const check::Scope& scope, const syntax::SkillUnit& skill) {
    for (const auto tree : scope.trees) {
      if (trees_[tree].lost || !has_all_names(trees_[tree])) return;
    }
    Diagnostics found;
    check::build_network(scope, skill, found);
    for (const Diagnostic& each : found.all()) {
      switch (each.code) {
        case Code::PAL0201:
        case Code::PAL0202:
        case Code::PAL0203:
        case Code::PAL0204: {
          diagnostics_.report(each);
          break;
        }
        default:
          break;
      }
    }
  }

  static bool has_all_names(const syntax::Tree& tree) {
    return std::all_of(tree.units.begin(), tree.units.end(), [](const syntax::Unit& unit) {
      if (const auto* message = std::get_if<syntax::MessageUnit>(&unit)) return !message->name.text.empty();
      if (const auto* condition = std::get_if<syntax::ConditionUnit>(&unit))
        return !condition->name.text.empty();
      if (const auto* device = std::get_if<syntax::DeviceUnit>(&unit)) return !device->name.text.empty();
      const auto* module = std::get_if<syntax::ModuleUnit>(&unit);
      if (module == nullptr) return true;
      return !module->name.text.empty() &&
             std::none_of(module->activities.begin(), module->activities.end(),
                          [](const auto& activity) { return activity.name.text.empty(); });
    });
  }

  void check_skill(std::size_t index, const syntax::SkillUnit& skill) {
    const auto scope = check::scope_of(trees_, index, diagnostics_);
    used_.insert(scope.trees.begin(), scope.trees.end());
    // What a syntax error hides would be missed everywhere else.
    if (!complete(scope)) return look_up_names(scope, skill);
    const auto before = diagnostics_.all().size();
    const auto errors_before = diagnostics_.errors();
    auto network = check::build_network(scope, skill, diagnostics_);
    const bool sound = every_name_known(before);
    check_network(network, sound);
    if (depth_ == Depth::all && sound && diagnostics_.errors() == errors_before)
      check::check_deadlocks(network, pan::Flow(network), diagnostics_, stop_);
    result_.skills.push_back(std::move(network));
    std::set<FileId> files;
    for (const std::size_t tree : scope.trees) files.insert(trees_[tree].file);
    result_.seen[trees_[index].file] = std::move(files);
  }

  /// What a file with skills declares beside them. Nothing is said of a file in which something is wrong.
  void check_leftovers(std::size_t index) {
    const FileId file = trees_[index].file;
    if (trees_[index].complete && trees_[index].units.empty())
      diagnostics_.report(Finding::file_declares_nothing, {file, 0, 0});
    if (diagnostics_.errors() != 0 || !trees_[index].complete) return;
    std::vector<const pan::Network*> skills;
    for (const auto& network : result_.skills) {
      if (network.skill.where.file == file) skills.push_back(&network);
    }
    if (skills.empty()) return;
    std::vector<const pan::Environment*> environments;
    for (const auto& environment : result_.environments) {
      if (environment.where.file == file) environments.push_back(&environment);
    }
    check::check_unused(trees_[index], skills, environments, diagnostics_);
    check_left_modules(index, skills);
  }

  /// Modules in the file of a skill that it does not list: checked by themselves.
  void check_left_modules(std::size_t index, const std::vector<const pan::Network*>& skills) {
    std::set<std::string_view> listed;
    for (const pan::Network* skill : skills) {
      for (const pan::Module& module : skill->modules) listed.insert(module.name);
    }
    for (const auto& unit : trees_[index].units) {
      const auto* module = std::get_if<syntax::ModuleUnit>(&unit);
      if (module == nullptr || module->name.text.empty() || listed.contains(module->name.text)) continue;
      diagnostics_.report(Finding::module_not_used, module->name.where);
    }
  }

  /// Files with modules that no skill sees: a sketch for each that no other such file uses.
  void check_unused(std::size_t index) {
    if (used_.contains(index)) return;
    const auto scope = check::scope_of(trees_, index, diagnostics_);
    // What a file uses that a skill uses too, as an environment does, is not unused for that.
    const auto& all = scope.modules.all();
    const auto left = std::find_if(all.begin(), all.end(), [this](const auto* module) {
      return std::none_of(used_.begin(), used_.end(),
                          [&](std::size_t used) { return trees_[used].file == module->name.where.file; });
    });
    used_.insert(scope.trees.begin(), scope.trees.end());
    if (left == all.end() || !complete(scope)) return;
    const auto& first = **left;
    diagnostics_.report(Finding::module_alone, first.name.where);
    const auto errors_before = diagnostics_.errors();
    auto network = check::build_sketch(scope, first.name.text, first.where, diagnostics_);
    if (diagnostics_.errors() == errors_before) check_bodies(network, pan::Flow(network));
    result_.sketches.push_back(std::move(network));
  }

  /// No finding since `first` says that a name in a body means nothing. (A figure in a template may be
  /// wrong.)
  bool every_name_known(std::size_t first) const {
    if (diagnostics_.not_kept().errors != 0) return false;  // they may say so
    const auto& all = diagnostics_.all();
    const auto guessed = [](const Diagnostic& finding) { return finding.code == Code::PAL0110; };
    if (std::any_of(all.begin(), all.end(), guessed)) return false;  // what a TXM sends, and its receiver
    return std::none_of(
        all.begin() + static_cast<std::ptrdiff_t>(first), all.end(), [](const Diagnostic& finding) {
          const Family about = family(finding.code);
          return finding.severity == Severity::error && (about == Family::names || about == Family::messages);
        });
  }

  /// `sound`: every name meant something. If not, statements are missing, and findings about talk and flow
  /// would be about another program than the user's.
  void check_network(const pan::Network& network, bool sound) {
    const auto errors_before = diagnostics_.errors();
    check::check_layers(network, diagnostics_);
    // A party that a module may not talk with does not answer it either: that would be said of the same
    // mistake again.
    if (!sound || diagnostics_.errors() != errors_before) return;
    const pan::Flow flow(network);
    check::check_channels(network, diagnostics_);
    check::check_protocol(network, flow, diagnostics_);
    check::check_starts(network, diagnostics_);
    check_bodies(network, flow);
  }

  void check_bodies(const pan::Network& network, const pan::Flow& flow) {
    check::check_askers(network, diagnostics_);
    check::check_writers(network, diagnostics_);
    check::check_reads(network, flow, diagnostics_);
    check::check_readers(network, flow, diagnostics_);
    check::check_flow(network, flow, diagnostics_);
    check::check_cases(network, flow, diagnostics_);
  }

  const std::vector<syntax::Tree>& trees_;
  Diagnostics& diagnostics_;
  const std::function<bool()>& stop_;
  const Depth depth_;
  Specification result_;
  std::set<std::size_t> used_;
  Declared environments_;
  Declared skills_;
  std::set<std::string> twice_;                             // names that several skills have that meet
  std::map<std::size_t, std::set<std::size_t>> seen_from_;  // by file
};

}  // namespace

Specification check(const std::vector<syntax::Tree>& trees, Diagnostics& diagnostics,
                    const std::function<bool()>& stop, Depth depth) {
  return Checker(trees, diagnostics, stop, depth).check();
}

}  // namespace pal::check
