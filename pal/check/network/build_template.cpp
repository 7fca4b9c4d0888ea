#include "pal/check/network/build_template.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "pal/check/network/parameters.hpp"
#include "pal/check/report.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"

namespace pal::check {

namespace {

class TemplateBuilder {
 public:
  TemplateBuilder(const syntax::SkillUnit& skill, Names& names, pan::Network& network,
                  Diagnostics& diagnostics)
      : skill_(skill), names_(names), network_(network), diagnostics_(diagnostics) {}

  void build() {
    auto& result = network_.skill;
    result.name = skill_.name.text;
    result.descriptions = skill_.descriptions;
    result.preconditions = skill_.preconditions;
    result.postconditions = skill_.postconditions;
    result.model_data = skill_.model_data;
    result.where = skill_.where;
    list(skill_.skill_methods, pan::ModuleKind::skill_module);
    list(skill_.sensor_drivers, pan::ModuleKind::sensor_driver);
    list(skill_.logical_sensors, pan::ModuleKind::logical_sensor);
    list(skill_.machine_controllers, pan::ModuleKind::machine_controller);
    contingencies();
    parameters();
    completions();
    if (skill_.skill_methods.empty()) {
      diagnostics_.report(Finding::no_skill_method, skill_.where, skill_.name.text);
    }
  }

 private:
  void list(const std::vector<syntax::Name>& listed, pan::ModuleKind kind) {
    std::map<std::string, const syntax::Name*> seen;
    for (const auto& name : listed) {
      const auto [first, fresh] = seen.emplace(name.text, &name);
      if (!fresh) {
        auto& finding = diagnostics_.report(Finding::listed_twice, name.where, name.text);
        finding.note(first->second->where, Remark::also_listed);
        continue;
      }
      enter(name, kind);
    }
  }

  std::optional<pan::ModuleId> enter(const syntax::Name& name, pan::ModuleKind kind) {
    const auto id = names_.module(name, true);
    if (!id) return std::nullopt;
    const auto& module = network_.modules[id->index()];
    if (module.kind != kind) {
      auto& finding = diagnostics_.report(Finding::listed_in_another_slot, name.where, name.text,
                                          kind_text(module.kind), kind_text(kind));
      finding.note(module.where, Remark::declared_here);
    }
    return id;
  }

  void contingencies() {
    std::map<int, SourceSpan> seen;
    for (const auto& written : skill_.contingencies) {
      const auto [first, fresh] = seen.emplace(written.number, written.where);
      if (!fresh) {
        auto& finding =
            diagnostics_.report(Finding::contingency_declared_twice, written.where, written.number);
        finding.note(first->second, Remark::also_declared);
      }
      pan::Contingency contingency{written.number, written.description, {}, written.where};
      if (!written.method) {
        const auto ends_with_it = [&written](const syntax::Completion& completion) {
          return completion.kind == pan::Completion::Kind::contingency &&
                 completion.contingency == written.number;
        };
        if (std::none_of(skill_.completions.begin(), skill_.completions.end(), ends_with_it))
          diagnostics_.report(Finding::contingency_without_method, written.where, written.number);
      } else if (const auto id = enter(*written.method, pan::ModuleKind::contingency_module)) {
        contingency.method = *id;
      }
      network_.skill.contingencies.push_back(std::move(contingency));
    }
  }

  void parameters() {
    std::map<std::string, const syntax::Name*> seen;
    for (const auto& written : skill_.parameters) {
      const auto [first, fresh] = seen.emplace(written.name.text, &written.name);
      if (!fresh) {
        report_twice(diagnostics_, "parameter", written.name, *first->second);
        continue;
      }
      network_.skill.parameters.push_back(build_parameter(written, diagnostics_));
    }
  }

  void completions() {
    std::map<int, SourceSpan> seen;
    bool has_error = false;
    for (const auto& written : skill_.completions) {
      const auto [first, fresh] = seen.emplace(written.code, written.where);
      if (!fresh) {
        auto& finding = diagnostics_.report(Finding::completion_declared_twice, written.where, written.code);
        finding.note(first->second, Remark::also_declared);
        continue;
      }
      has_error = has_error || written.kind == pan::Completion::Kind::error;
      check_contingency(written);
      network_.skill.completions.push_back(
          {written.code, written.kind, written.contingency, written.description, written.where});
    }
    if (!has_error) {
      diagnostics_.report(Finding::no_error_completion, skill_.where, skill_.name.text);
    }
  }

  void check_contingency(const syntax::Completion& completion) {
    if (completion.kind != pan::Completion::Kind::contingency) return;
    for (const auto& contingency : skill_.contingencies) {
      if (contingency.number == completion.contingency) return;
    }
    diagnostics_.report(Finding::completion_for_unknown_contingency, completion.where, completion.code,
                        completion.contingency);
  }

  const syntax::SkillUnit& skill_;
  Names& names_;
  pan::Network& network_;
  Diagnostics& diagnostics_;
};

}  // namespace

void build_template(const syntax::SkillUnit& skill, Names& names, pan::Network& network,
                    Diagnostics& diagnostics) {
  TemplateBuilder(skill, names, network, diagnostics).build();
}

}  // namespace pal::check
