// What an editor offers beyond verdicts: slack beside times, and changes that were tried, as edits of texts.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "analyzer/analysis.hpp"
#include "analyzer/whatif/remedy.hpp"
#include "analyzer/whatif/slack.hpp"
#include "pal/pan/times.hpp"
#include "pal/support/duration_text.hpp"
#include "pal/syntax/text_tokens.hpp"
#include "programs/pal/reports/editor_proofs.hpp"
#include "programs/pal/session/program_changes.hpp"
#include "programs/pal/session/proof.hpp"

namespace pal::program {
namespace {

using analyzer::whatif::Change;

/// The texts that a proof is of, as files.
class SourceFiles : public FileSystem {
 public:
  explicit SourceFiles(const SourceManager& sources) : sources_(sources) {}

  std::variant<std::string, FileError> read(const std::string& path, std::size_t) const override {
    const auto file = sources_.find(path);
    if (!file) return FileError{"it is no part of the skill"};
    return std::string(sources_.text(*file));
  }
  std::string identity(const std::string& path) const override { return path; }

 private:
  const SourceManager& sources_;
};

/// The line of the environment that a figure stands for; costs and latencies have none.
SourceSpan place_of_figure(const std::string& figure, const pan::Environment& environment) {
  for (const auto& each : environment.activities) {
    if (figure == each.activity || figure == each.activity + " OF " + each.module) return each.where;
  }
  for (const auto& each : environment.devices) {
    if (figure == "answer of " + each.device) return each.where;
  }
  return {};
}

/// The word behind `word`, in capitals, in the text at `where`.
std::optional<SourceSpan> behind(const SourceManager& sources, const SourceSpan& where,
                                 std::string_view word) {
  const auto text = sources.text(where);
  const auto tokens = syntax::text_tokens(text);
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    std::string upper(text.substr(tokens[i].begin, tokens[i].end - tokens[i].begin));
    for (char& c : upper) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
    if (upper == word)
      return SourceSpan{where.file, where.begin + tokens[i + 1].begin, where.begin + tokens[i + 1].end};
  }
  return std::nullopt;
}

/// Changes of an environment as edits of its text.
class EnvironmentEdits {
 public:
  EnvironmentEdits(const SourceManager& sources, const pan::Environment& environment)
      : sources_(sources), environment_(environment) {}

  /// Nothing: the change stands in no line of the text, or changes the world, not the program.
  std::optional<Edit> edit(const Change& change) const {
    if (change.kind == Change::Kind::new_processor) return new_processor(text(change));
    if (change.kind == Change::Kind::period) return std::nullopt;
    const std::string_view word = change.kind == Change::Kind::priority ? "PRIORITY" : "ON";
    for (const auto& place : environment_.placements) {
      if (place.thread != change.of) continue;
      if (const auto found = behind(sources_, place.where, word)) return Edit{*found, change.value};
    }
    return std::nullopt;
  }

  std::optional<Edit> shorter(const std::string& figure, const Interval& enough) const {
    const auto where = place_of_figure(figure, environment_);
    if (!where.valid()) return std::nullopt;
    const auto text = sources_.text(where);
    const auto tokens = syntax::text_tokens(text);
    // The figures stand at the end: "1 TO 3 ms", "3 ms".
    std::optional<std::uint32_t> begin;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      const bool number = tokens[i].kind == syntax::TextToken::Kind::number;
      if (number && !begin) begin = tokens[i].begin;
    }
    if (!begin) return std::nullopt;
    return Edit{{where.file, where.begin + *begin, where.end}, to_text(enough)};
  }

 private:
  std::optional<Edit> new_processor(const std::string& declaration) const {
    if (environment_.processors.empty()) return std::nullopt;
    const auto& last = environment_.processors.back().where;
    const auto text = sources_.text(last.file);
    const auto line = text.rfind('\n', last.begin) + 1;
    const auto first = text.find_first_not_of(" \t", line);
    const std::string indentation(text.substr(line, first == std::string_view::npos ? 0 : first - line));
    return Edit{{last.file, last.end, last.end}, "\n" + indentation + declaration};
  }

  const SourceManager& sources_;
  const pan::Environment& environment_;
};

/// The edits of another SourceManager with the same names.
std::vector<Edit> moved(const std::vector<Edit>& edits, const SourceManager& from, const SourceManager& to) {
  std::vector<Edit> result;
  for (Edit edit : edits) {
    const auto file = to.find(from.name(edit.where.file));
    if (!file) return {};
    edit.where.file = *file;
    result.push_back(std::move(edit));
  }
  return result;
}

void add_slacks(const pan::Network& skill, const pan::Environment& environment,
                const analyzer::Options& options, language_server::Advice& advice) {
  for (const auto& slack : analyzer::whatif::slacks(skill, environment, options)) {
    const auto where = place_of_figure(slack.figure, environment);
    if (!where.valid() || (!slack.holds && !slack.unlimited)) continue;
    const std::string amount =
        slack.unlimited ? "unlimited" : (slack.exact() ? "" : ">= ") + to_text(*slack.holds);
    std::string words = "the worst time of " + slack.figure + " may grow by " + amount;
    if (slack.exact() && !slack.unlimited && slack.requirement.valid())
      words += "; then '" + skill.requirements[slack.requirement.index()].name + "' fails";
    advice.slacks.push_back({where, amount, std::move(words)});
  }
}

void add_cures(const pan::Network& skill, const pan::Environment& environment, const SourceManager& sources,
               const analyzer::Options& options, language_server::Advice& advice) {
  Selection selection;
  for (std::size_t i = 0; i < sources.size(); ++i) selection.files.push_back(sources.name(FileId(i)));
  const SourceFiles files(sources);
  ProgramChanges programs(selection, skill, {}, files);
  const auto remedies = analyzer::whatif::find_remedies(
      skill, environment, programs.all().size(),
      [&programs](const auto& made) { return programs.network_with(made); }, options);
  const EnvironmentEdits of_environment(sources, environment);
  std::vector<std::string> unmet;
  for (const auto& verdict : remedies.before) {
    if (verdict.state != analyzer::VerdictState::holds) unmet.push_back(verdict.requirement);
  }
  for (const auto& remedy : remedies.found) {
    language_server::Cure cure;
    cure.requirements = unmet;
    bool whole = true;
    for (const auto id : remedy.made) {
      const auto& candidate = remedies.candidates[id.index()];
      const auto say = [&](const std::string& words) {
        cure.title += (cure.title.empty() ? "" : ", and ") + words;
      };
      if (candidate.program.valid()) {
        const auto& change = programs.all()[candidate.program.index()];
        say((change.module.empty() ? "" : "in " + change.module + ": ") + change.title);
        const auto edits = moved(programs.edits(candidate.program), programs.sources(), sources);
        whole = whole && !edits.empty();
        cure.edits.insert(cure.edits.end(), edits.begin(), edits.end());
      }
      for (const auto& change : candidate.changes) {
        say(words(change));
        const auto edit = of_environment.edit(change);
        whole = whole && edit;
        if (edit) cure.edits.push_back(*edit);
      }
    }
    if (whole && !cure.edits.empty()) advice.cures.push_back(std::move(cure));
  }
  // A time that is promised shorter mends everything if nothing else is wrong.
  for (const auto& each : remedies.short_enough) {
    const auto edit = of_environment.shorter(each.figure, each.enough);
    if (!edit || unmet.size() != 1) continue;
    advice.cures.push_back(
        {"promise " + to_text(each.enough) + " for " + each.figure + ", instead of " + to_text(each.time),
         {remedies.before[each.requirement.index()].requirement},
         {*edit}});
  }
}

}  // namespace

language_server::Advice EditorProver::advise(const pan::Network& skill, const pan::Environment& given,
                                             const SourceManager& sources, double seconds,
                                             const std::function<bool()>& stop) const {
  const pan::Environment environment = pan::with_times_of(skill, given);
  language_server::Advice advice;
  advice.skill = skill.skill.name;
  Diagnostics diagnostics;
  const auto problem = analyzer::make_problem(skill, environment, diagnostics, &sources);
  if (!problem || diagnostics.has_errors()) return advice;
  ProofLimits limits;
  limits.seconds = seconds;
  analyzer::Options options = options_of(limits);
  options.addends = false;
  options.stop = [usual = options.stop, stop] { return usual() || stop(); };
  const auto now = analyzer::analyze(*problem, analyzer::AnalysisChoice::automatic, options);
  const auto is = [&](analyzer::VerdictState state) {
    return std::any_of(now.verdicts.begin(), now.verdicts.end(),
                       [&](const auto& each) { return each.state == state; });
  };
  if (now.verdicts.empty() || stop()) return advice;
  if (is(analyzer::VerdictState::fails)) {
    add_cures(skill, environment, sources, options, advice);
  } else if (!is(analyzer::VerdictState::undecided) && !is(analyzer::VerdictState::never)) {
    add_slacks(skill, environment, options, advice);
  }
  return advice;
}

}  // namespace pal::program
