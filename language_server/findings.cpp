// Findings of open files, and their cures as code actions.
#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <utility>

#include "language_server/repair.hpp"
#include "language_server/session.hpp"
#include "pal/support/diagnostic_code.hpp"
#include "pal/support/edit.hpp"
#include "pal/support/finding.hpp"

namespace pal::language_server {

namespace {

/// What these findings are about does nothing: editors fade it.
bool is_unused(Code code) {
  return code == Code::PAL0217 || code == Code::PAL0209 || code == Code::PAL0501 || code == Code::PAL0406 ||
         code == Code::PAL0731 || code == Code::PAL0723;
}

int level(Severity severity) {
  return severity == Severity::error ? 1 : severity == Severity::warning ? 2 : 3;
}

/// Where a span stands, as a location of the protocol.
using Locate = std::function<Json(const SourceSpan&)>;

Json diagnostic_at(const Diagnostic& finding, const Locate& locate, const std::string& documentation) {
  std::string message = finding.message;
  Json related = Json::array();
  for (const auto& note : finding.notes) {
    if (note.where.valid()) {
      related.push_back({{"location", locate(note.where)}, {"message", note.text}});
    } else {
      message += "\n" + note.text;
    }
  }
  if (!finding.hint.empty()) message += "\nhint: " + finding.hint;
  Json result{{"range", locate(finding.where)["range"]},
              {"severity", level(finding.severity)},
              {"code", name(finding.code)},
              {"source", "pal"},
              {"message", message}};
  Json arguments = Json::object();
  for (const auto& [argument, text] : named_arguments(finding)) arguments[std::string(argument)] = text;
  result["data"] = {{"finding", row(finding.finding).name}, {"arguments", std::move(arguments)}};
  if (!related.empty()) result["relatedInformation"] = std::move(related);
  if (is_unused(finding.code)) result["tags"] = {1};
  if (!documentation.empty()) {
    std::string anchor(name(finding.code));
    for (char& c : anchor) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    result["codeDescription"] = {{"href", documentation + "/reference/diagnostics.md#" + anchor}};
  }
  return result;
}

Json diagnostic(const Diagnostic& finding, const Analysis& analysis, const Workspace& workspace,
                const std::string& documentation) {
  const auto locate = [&](const SourceSpan& where) -> Json {
    return {{"uri", workspace.uri(analysis.path(where.file))},
            {"range", range_of(analysis.text(where.file), where.begin, where.end)}};
  };
  return diagnostic_at(finding, locate, documentation);
}

std::string shortened(std::string_view text) {
  std::string result;
  for (const char c : text) result += c == '\n' || c == '\t' ? ' ' : c;
  constexpr std::size_t most = 40;
  return result.size() > most ? result.substr(0, most) + "…" : result;
}

std::string title_of(const Diagnostic& finding, const Analysis& analysis) {
  if (finding.fix.size() != 1) return finding.hint.empty() ? "make the change" : finding.hint;
  const Edit& edit = finding.fix.front();
  const std::string before = shortened(analysis.sources.text(edit.where));
  if (before.empty()) return "insert '" + shortened(edit.text) + "'";
  if (edit.text.empty()) return "remove '" + before + "'";
  return "replace '" + before + "' by '" + shortened(edit.text) + "'";
}

/// Of edits that overlap, the first is made.
Json workspace_edit(std::vector<Edit> edits, const Analysis& analysis, const Workspace& workspace) {
  std::stable_sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) {
    return std::pair(a.where.file, a.where.begin) < std::pair(b.where.file, b.where.begin);
  });
  Json changes = Json::object();
  SourceSpan last;
  for (const Edit& edit : edits) {
    if (last.valid() && last.file == edit.where.file && edit.where.begin < last.end) continue;
    last = edit.where;
    changes[workspace.uri(analysis.path(edit.where.file))].push_back(
        text_edit(analysis.text(edit.where.file), edit.where.begin, edit.where.end, edit.text));
  }
  return {{"changes", std::move(changes)}};
}

}  // namespace

Json Session::operation_diagnostic(const Diagnostic& finding, const SourceManager& sources) const {
  const auto locate = [&](const SourceSpan& where) -> Json {
    const auto& path = sources.name(where.file);
    const auto text = workspace_.text(path);
    return {{"uri", workspace_.uri(path)},
            {"range", range_of(text != nullptr ? *text : Text(), where.begin, where.end)}};
  };
  return diagnostic_at(finding, locate, options_.documentation);
}

std::vector<std::string> Session::roots_of(const std::string& path) {
  auto roots = index_.roots(path);
  for (const auto& [root, known] : known_) {  // an environment: the open skills that are checked with it
    if (known.analysis != nullptr && known.analysis->file(path) &&
        std::find(roots.begin(), roots.end(), root) == roots.end())
      roots.push_back(root);
  }
  return roots;
}

std::map<std::string, std::vector<std::string>> Session::roots_of_open() {
  std::map<std::string, std::vector<std::string>> result;
  for (const auto& [path, document] : workspace_.documents()) {
    if (path.ends_with(".pal")) result[path] = index_.roots(path);
  }
  for (const auto& [root, known] : known_) {  // environments, as in roots_of()
    for (std::size_t i = 0; known.analysis != nullptr && i < known.analysis->sources.size(); ++i) {
      const auto open = result.find(known.analysis->path(FileId(i)));
      if (open != result.end() &&
          std::find(open->second.begin(), open->second.end(), root) == open->second.end())
        open->second.push_back(root);
    }
  }
  return result;
}

const Known& Session::known(const std::string& root) {
  Known& known = known_[root];
  if (const auto structure = workspace_.structure(); known.inputs_of != structure) {
    known.inputs = inputs_of(workspace_, root, environments_);
    known.inputs_of = structure;
  }
  if (known.analysis == nullptr || !is_current(*known.analysis, workspace_, known.inputs)) {
    known.analysis = analyze(workspace_, known.inputs, {});
    known.under_way = nullptr;
    if (!known.analysis->diagnostics.has_errors()) known.sound = known.analysis;
  }
  return known;
}

std::vector<Diagnostic> Session::findings(const Known& known, const std::string& path) const {
  std::vector<Diagnostic> result;
  const auto file = known.analysis->file(path);
  if (!file) return result;
  const auto add = [&](const std::vector<Diagnostic>& all) {
    for (const auto& finding : all) {
      if (finding.where.valid() && finding.where.file == *file) result.push_back(finding);
    }
  };
  add(known.analysis->diagnostics.sorted());
  const Proofs* proofs = known.current();
  if (proofs == nullptr) return result;
  for (const auto& proof : *proofs) {
    add(proof.findings);
    if (proof.ended) continue;  // what had no time to be decided is no finding while typing
    for (const auto& requirement : proof.requirements) add(requirement.findings);
  }
  add(causes(known, path));
  return result;
}

/// A requirement that fails is told where it stands, and once more at the statement to change: the first
/// that a cure of the text changes, else the one that most of the time is spent on.
std::vector<Diagnostic> Session::causes(const Known& known, const std::string& path) const {
  std::vector<Diagnostic> result;
  const auto file = known.analysis->file(path);
  for (const auto& proof : *known.current()) {
    for (const auto& each : proof.requirements) {
      if (each.state != "fails" || each.findings.empty() || !each.cause.valid()) continue;
      Diagnostic made = each.findings.front();
      made.severity = Severity::warning;
      made.notes = {Note(made.where, Remark::required_here, each.name)};
      made.where = each.cause;
      made.message = "'" + each.name + "' fails here: " + each.cause_text;
      made.fix.clear();
      bool cured = false;
      const bool advised = known.advice != nullptr && known.proved == known.analysis;
      for (std::size_t i = 0; advised && i < known.advice->size(); ++i) {
        const auto& advice = (*known.advice)[i];
        for (const auto& cure : advice.cures) {
          if (advice.skill != proof.skill || cure.edits.empty() || cured) continue;
          cured = true;
          made.hint = "cure: " + cure.title;
        }
      }
      if (file && made.where.file == *file) result.push_back(std::move(made));
    }
  }
  return result;
}

void Session::publish() {
  std::map<std::string, Published> shown;
  const auto add = [&](const Known& known, const std::string& path, Json& list) {
    for (const auto& finding : findings(known, path)) {
      Json made = diagnostic(finding, *known.analysis, workspace_, options_.documentation);
      if (std::find(list.begin(), list.end(), made) == list.end()) list.push_back(std::move(made));
    }
  };
  // What has neither another text nor other findings than the client shows is not sent again.
  const auto publish = [&](const std::string& path, Published state, const Document* document,
                           const auto& fill) {
    const auto before = published_.find(path);
    const bool same = before != published_.end() && before->second == state;
    shown.emplace(path, std::move(state));
    if (same) return;
    Json list = Json::array();
    fill(list);
    Json params{{"uri", workspace_.uri(path)}, {"diagnostics", std::move(list)}};
    if (document != nullptr) params["version"] = document->version;
    notify("textDocument/publishDiagnostics", std::move(params));
  };
  for (const auto& [path, roots] : roots_of_open()) {
    const auto* document = workspace_.find(path);
    Published state{document->version, {}};
    std::vector<const Known*> all;
    for (const auto& root : roots) {
      const auto known = known_.find(root);
      if (known == known_.end() || known->second.analysis == nullptr) continue;
      all.push_back(&known->second);
      for (const std::shared_ptr<const void>& each : {std::shared_ptr<const void>(known->second.analysis),
                                                      std::shared_ptr<const void>(known->second.proofs),
                                                      std::shared_ptr<const void>(known->second.proved),
                                                      std::shared_ptr<const void>(known->second.under_way),
                                                      std::shared_ptr<const void>(known->second.advice)})
        state.from.push_back(each);
    }
    publish(path, std::move(state), document, [&](Json& list) {
      for (const auto* known : all) add(*known, path, list);
    });
  }
  for (const auto& [path, document] : workspace_.documents()) {
    if (!is_operation(path)) continue;
    // Another file may be a part of it, or a skill of it.
    publish(path, {document.version, {std::make_shared<const int>(0)}}, &document, [&](Json& list) {
      SourceManager sources;
      for (const auto& finding : operation_findings(path, sources))
        list.push_back(operation_diagnostic(finding, sources));
    });
  }
  // A mistake here may be a finding in a file that is not open.
  std::map<std::string, std::vector<const Known*>> elsewhere;
  for (const auto& [root, known] : known_) {
    if (known.analysis == nullptr ||
        (known.analysis->diagnostics.all().empty() && known.current() == nullptr))
      continue;
    for (std::size_t i = 0; i < known.analysis->sources.size(); ++i) {
      const auto& path = known.analysis->path(FileId(i));
      if (workspace_.find(path) == nullptr && !findings(known, path).empty())
        elsewhere[path].push_back(&known);
    }
  }
  for (const auto& [path, all] : elsewhere) {
    Published state;
    for (const auto* known : all) {
      state.from.push_back(known->analysis);
      state.from.push_back(known->proofs);
      state.from.push_back(known->proved);
      state.from.push_back(known->under_way);
    }
    publish(path, std::move(state), nullptr, [&](Json& list) {
      for (const auto* known : all) add(*known, path, list);
    });
  }
  for (const auto& [path, state] : published_) {
    if (!shown.contains(path))
      notify("textDocument/publishDiagnostics",
             {{"uri", workspace_.uri(path)}, {"diagnostics", Json::array()}});
  }
  published_ = std::move(shown);
}

bool Session::check(const std::function<bool()>& newer) {
  if (to_check_.empty()) return true;
  jobs_.clear();  // of a check that a newer text ended: what is still to be proved is found again
  std::set<std::string> roots;
  for (const auto& [path, of] : roots_of_open()) roots.insert(of.begin(), of.end());
  std::erase_if(known_, [&](const auto& each) { return !roots.contains(each.first); });
  for (const auto& root : roots) {
    if (newer && newer()) return false;
    const auto before = known_[root].analysis;
    const Known& now = known(root);
    if (now.analysis != before || now.proved != now.analysis) {
      if (options_.prover != nullptr && proof_seconds_ > 0 && !now.analysis->diagnostics.has_errors() &&
          now.proved != now.analysis)
        jobs_.push_back({now.analysis, workspace_.revision(), proof_seconds_});
    }
  }
  to_check_.clear();
  publish();
  tell_changed("text");
  return true;
}

std::vector<ProofJob> Session::take_jobs() {
  return std::exchange(jobs_, {});
}

void Session::proved(const ProofJob& job, Proofs proofs) {
  const auto found = known_.find(job.analysis->root);
  if (found == known_.end() || found->second.analysis != job.analysis) return;  // of an earlier text
  found->second.proved = job.analysis;
  found->second.proofs = std::make_shared<const Proofs>(std::move(proofs));
  found->second.under_way = nullptr;
  found->second.advice = nullptr;
  publish();
  tell_changed("proof");
  if (refreshes_hints_) ask_client("workspace/inlayHint/refresh", nullptr);
  if (refreshes_lenses_) ask_client("workspace/codeLens/refresh", nullptr);
}

void Session::told(const ProofJob& job, Proofs proofs) {
  const auto found = known_.find(job.analysis->root);
  if (found == known_.end() || found->second.analysis != job.analysis || found->second.proved == job.analysis)
    return;
  const auto says = [](const ProvedRequirement& each) { return each.state != "open" || !each.bound.empty(); };
  if (std::none_of(proofs.begin(), proofs.end(), [&](const SkillProof& proof) {
        return std::any_of(proof.requirements.begin(), proof.requirements.end(), says);
      }))
    return;
  found->second.under_way = std::make_shared<const Proofs>(std::move(proofs));
  publish();
  tell_changed("proof");
  if (refreshes_hints_) ask_client("workspace/inlayHint/refresh", nullptr);
}

void Session::advised(const ProofJob& job, AllAdvice advice) {
  const auto found = known_.find(job.analysis->root);
  if (found == known_.end() || found->second.analysis != job.analysis) return;
  found->second.advice = std::make_shared<const AllAdvice>(std::move(advice));
  publish();  // a cure may be at another statement than the cause
  if (refreshes_hints_) ask_client("workspace/inlayHint/refresh", nullptr);
}

void Session::show_progress(const ProofJob& job) {
  if (!progress_ || !progress_shown_.empty()) return;
  progress_shown_ = "pal-proof-" + std::to_string(asked_ + 1);
  ask_client("window/workDoneProgress/create", {{"token", progress_shown_}});
  std::string names;
  for (const auto& skill : job.analysis->specification.skills)
    names += (names.empty() ? "" : ", ") + skill.skill.name;
  notify("$/progress",
         {{"token", progress_shown_},
          {"value", {{"kind", "begin"}, {"title", "proving"}, {"message", names}, {"cancellable", false}}}});
}

void Session::hide_progress() {
  if (progress_shown_.empty()) return;
  notify("$/progress", {{"token", progress_shown_}, {"value", {{"kind", "end"}}}});
  progress_shown_.clear();
}

void Session::tell_changed(const char* what) {
  if (!pictures_) return;
  Json uris = Json::array();
  for (const auto& [path, document] : workspace_.documents()) uris.push_back(document.uri);
  notify("pal/changed", {{"uris", std::move(uris)}, {"what", what}});
}

Json Session::operation_actions(const std::string& path, const Text& text, std::uint32_t begin,
                                std::uint32_t end) {
  SourceManager sources;
  Json actions = Json::array();
  for (const auto& finding : operation_findings(path, sources)) {
    const bool here = std::all_of(finding.fix.begin(), finding.fix.end(),
                                  [&](const Edit& edit) { return edit.where.file == finding.where.file; });
    if (finding.fix.empty() || !here || finding.where.end < begin || finding.where.begin > end) continue;
    Json edits = Json::array();
    for (const auto& edit : finding.fix)
      edits.push_back(text_edit(text, edit.where.begin, edit.where.end, edit.text));
    actions.push_back({{"title", finding.hint.empty() ? "make the change" : finding.hint},
                       {"kind", "quickfix"},
                       {"isPreferred", true},
                       {"diagnostics", {operation_diagnostic(finding, sources)}},
                       {"edit", {{"changes", {{workspace_.uri(path), std::move(edits)}}}}}});
  }
  return actions;
}

Json Session::code_action(const Json& params) {
  const auto path = path_in(params);
  const auto text = workspace_.text(path);
  if (text == nullptr) return Json::array();
  const Json& range = member(params, "range");
  const auto begin = text->offset(position_of(member(range, "start")));
  const auto end = text->offset(position_of(member(range, "end")));
  if (is_operation(path)) return operation_actions(path, *text, begin, end);
  const Json& only = member(member(params, "context"), "only");
  const auto wants = [&](std::string_view kind) {
    if (!only.is_array() || only.empty()) return true;
    return std::any_of(only.begin(), only.end(), [&](const Json& each) {
      const auto asked = each.is_string() ? each.get<std::string>() : std::string();
      return kind == asked || kind.starts_with(asked + ".");
    });
  };
  Json actions = Json::array();
  const auto add = [&](Json action) {
    if (std::find(actions.begin(), actions.end(), action) == actions.end())
      actions.push_back(std::move(action));
  };
  std::vector<Edit> all;
  std::shared_ptr<const Analysis> analysis_of_all;
  for (const auto& root : roots_of(path)) {
    const Known& here = known(root);
    const Analysis& analysis = *here.analysis;
    const auto found = findings(here, path);
    for (const auto& finding : found) {
      if (finding.fix.empty()) {
        if (finding.where.end < begin || finding.where.begin > end || !wants("quickfix")) continue;
        for (const auto& repair : repairs(workspace_, analysis, finding, options_.repair_seconds))
          add({{"title", repair.title},
               {"kind", "quickfix"},
               {"diagnostics", {diagnostic(finding, analysis, workspace_, options_.documentation)}},
               {"edit", workspace_edit(repair.edits, analysis, workspace_)}});
        continue;
      }
      if (analysis_of_all == nullptr || analysis_of_all == here.analysis) {
        analysis_of_all = here.analysis;
        all.insert(all.end(), finding.fix.begin(), finding.fix.end());
      }
      if (finding.where.end < begin || finding.where.begin > end || !wants("quickfix")) continue;
      const Json told = diagnostic(finding, analysis, workspace_, options_.documentation);
      add({{"title", title_of(finding, analysis)},
           {"kind", "quickfix"},
           {"isPreferred", true},
           {"diagnostics", {told}},
           {"edit", workspace_edit(finding.fix, analysis, workspace_)}});
      std::vector<Edit> of_kind;
      std::size_t count = 0;
      for (const auto& other : found) {
        if (other.code != finding.code || other.fix.empty()) continue;
        of_kind.insert(of_kind.end(), other.fix.begin(), other.fix.end());
        ++count;
      }
      if (count > 1)
        add({{"title", "fix all " + std::to_string(count) + ": " + std::string(title(finding.code))},
             {"kind", "quickfix"},
             {"edit", workspace_edit(of_kind, analysis, workspace_)}});
    }
  }
  for (const auto& root : roots_of(path)) {
    const Known& here = known(root);
    if (here.advice == nullptr || here.proved != here.analysis || !wants("quickfix")) continue;
    const auto found = findings(here, path);
    for (const auto& advice : *here.advice) {
      for (const auto& cure : advice.cures) {
        Json told = Json::array();
        for (const auto& finding : found) {
          const auto& of = cure.requirements;
          if (std::find(of.begin(), of.end(), finding.requirement) != of.end() &&
              finding.where.end >= begin && finding.where.begin <= end)
            told.push_back(diagnostic(finding, *here.analysis, workspace_, options_.documentation));
        }
        if (!told.empty())
          add({{"title", cure.title},
               {"kind", "quickfix"},
               {"diagnostics", std::move(told)},
               {"edit", workspace_edit(cure.edits, *here.analysis, workspace_)}});
      }
    }
  }
  if (!all.empty() && wants("source.fixAll.pal") && only.is_array() && !only.empty())
    add({{"title", "fix all that can be fixed"},
         {"kind", "source.fixAll.pal"},
         {"edit", workspace_edit(all, *analysis_of_all, workspace_)}});
  return actions;
}

}  // namespace pal::language_server
