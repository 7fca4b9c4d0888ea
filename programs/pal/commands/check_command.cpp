// pal check: findings, verdicts, and the exit status that they make.
#include <algorithm>
#include <memory>
#include <ostream>
#include <sstream>

#include "pal/check/read_sources.hpp"
#include "pal/pan/dump.hpp"
#include "pal/support/finding.hpp"
#include "pal/support/output.hpp"
#include "pal/syntax/print.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/reports/check_display.hpp"
#include "programs/pal/reports/check_report.hpp"
#include "programs/pal/reports/junit.hpp"
#include "programs/pal/reports/sarif.hpp"
#include "programs/pal/reports/statistics.hpp"
#include "programs/pal/reports/witness.hpp"
#include "programs/pal/session/changed_since.hpp"
#include "programs/pal/session/colour.hpp"
#include "programs/pal/session/interruption.hpp"
#include "programs/pal/session/patience.hpp"
#include "programs/pal/session/unchecked.hpp"
#include "programs/pal/session/write.hpp"

namespace pal::program {
namespace {

ExitStatus emit_tree(const Selection& selection, const Console& console) {
  Session session;
  session.max_errors = selection.max_errors;
  for (const syntax::Tree& tree :
       check::read_sources(console.files, session.sources, selection.files, session.diagnostics)) {
    syntax::dump(tree, session.sources, console.out);
  }
  show_findings(session, console);
  return status_of_findings(session);
}

void emit_pan(const check::Specification& specification, std::ostream& out) {
  for (const pan::Network& network : specification.skills) pan::dump(network, out);
  for (const pan::Network& network : specification.sketches) pan::dump(network, out);
  for (const pan::Environment& environment : specification.environments) pan::dump(environment, out);
}

bool all_left_out(const std::vector<Unchecked>& not_checked) {
  return !not_checked.empty() && std::all_of(not_checked.begin(), not_checked.end(),
                                             [](const Unchecked& row) { return row.left_out; });
}

/// Of a report in text. The rows of the table have the reasons of each requirement.
void say_what_was_not_checked(const std::vector<Unchecked>& not_checked, bool any_verdict, bool without_times,
                              std::ostream& err) {
  if (not_checked.empty() || without_times) return;
  if (!any_verdict && all_left_out(not_checked)) {
    err << "pal: nothing was proved, since nothing has changed that a proof depends on\n";
    return;
  }
  const Unchecked& first = not_checked.front();
  if (any_verdict) {
    err << "pal: " << text_of(finding_of(first));
    if (not_checked.size() > 1) err << "; nor " << not_checked.size() - 1 << " more";
    err << (first.left_out ? "\n" : " (--require-verdicts makes this an error)\n");
    return;
  }
  err << "pal: no time was checked: " << first.reason << " (" << first.hint
      << "; --without-times checks everything but times)\n";
}

ExitStatus status_of(const std::vector<Proof>& proofs, const std::vector<Unchecked>& not_checked,
                     const CheckOptions& options) {
  if (!all_hold(proofs)) return ExitStatus::not_met;
  const bool only_left_out = all_left_out(not_checked);
  if (options.require_verdicts && !not_checked.empty() && !only_left_out) return ExitStatus::not_met;
  return has_verdicts(proofs) || only_left_out || options.without_times ? ExitStatus::all_hold
                                                                        : ExitStatus::not_met;
}

struct Input {
  std::shared_ptr<Session> session = std::make_shared<Session>();
  bool chosen = true;  // what the command line names was found
  bool whole = true;   // false: Ctrl-C came before all was read, and nothing of it is known
};

Input read_in_patience(const CheckOptions& options, const Console& console) {
  Input input;
  const auto chosen = std::make_shared<bool>(true);
  limit_checks(options.limits, *input.session);
  const auto work = [session = input.session, selection = options.selection, console, chosen] {
    *chosen = read(selection, console, *session);
  };
  if (done_in_patience(work)) {
    input.chosen = *chosen;
  } else {
    input.session = std::make_shared<Session>();
    input.whole = false;
    console.err << "pal: ended by you while the files were read\n";
  }
  return input;
}

Unproved why_unproved(const Input& input, const CheckOptions& options) {
  if (!input.whole) return Unproved::ended_by_user;
  if (input.session->diagnostics.has_errors()) return Unproved::wrong;
  if (options.without_times) return Unproved::not_asked_for;
  return Interruption::asked_for() ? Unproved::ended_by_user : Unproved::nowhere;
}

/// What went wrong, or nothing.
std::optional<std::string> write_witnesses(const std::string& path, const std::vector<Proof>& proofs,
                                           const Session& session) {
  std::ostringstream text;
  analyzer::run_checker::write_witnesses(witnesses_of(proofs, session), text);
  return write_files({{path, text.str()}});
}

/// Says how many proofs were kept ones, and keeps the folder at its size.
void tidy(const study::ProofStore& cache, const CheckOptions& options, const std::vector<Proof>& proofs,
          std::ostream& err) {
  cache.trim(options.cache_size);
  if (cache.damaged() > 0)
    err << "pal: " << cache.damaged() << " kept proofs were damaged, and were made again\n";
  const auto kept =
      std::count_if(proofs.begin(), proofs.end(), [](const Proof& proof) { return proof.kept; });
  if (!options.quiet)
    err << "pal: " << kept << " of " << proofs.size() << " proofs were kept ones, of " << options.cache
        << "\n";
}

}  // namespace

ExitStatus check(const CheckOptions& options, const Console& console) {
  if (options.emit == Stage::tree) return emit_tree(options.selection, console);
  const Interruption interruption;  // till all is written
  const Input input = read_in_patience(options, console);
  if (!input.chosen) return ExitStatus::usage;
  Session& session = *input.session;
  if (!may_write({options.witness}, inputs_of(session), console)) return ExitStatus::usage;
  if (options.emit == Stage::pan) emit_pan(session.specification, console.out);

  std::vector<LeftOut> left_out;
  if (!options.changed_since.empty() && !session.diagnostics.has_errors()) {
    auto unchanged = unchanged_since(options.changed_since, session);
    if (const auto* wrong = std::get_if<std::string>(&unchanged)) {
      console.err << "pal: " << *wrong << "\n";
      return ExitStatus::usage;
    }
    left_out = std::get<std::vector<LeftOut>>(std::move(unchanged));
  }
  std::vector<Proof> proofs;
  study::ProofStore cache(options.cache);
  if (!session.diagnostics.has_errors() && !options.without_times) {
    ProofLimits limits = options.limits;
    limits.peak_memory = options.statistics;
    limits.addends = options.explain || options.format == Format::json;
    limits.cache = options.cache.empty() ? nullptr : &cache;
    limits.leaves_out = [&left_out](const pan::Network& skill, const pan::Environment& environment) {
      return std::any_of(left_out.begin(), left_out.end(), [&](const LeftOut& each) {
        return each.skill == &skill && each.environment == &environment;
      });
    };
    limits.fresh = options.statistics || !options.witness.empty();
    if (console.terminal && options.format == Format::text && !options.quiet) {
      CheckDisplay display(console.out, terminal_size());
      proofs = prove(
          session, limits,
          [&display](const auto& problem, const auto& known) { display.show(problem, known); },
          input.session);
    } else {
      proofs = prove(session, limits, {}, input.session);
    }
  }
  if (!options.cache.empty()) tidy(cache, options, proofs, console.err);
  std::vector<Unchecked> not_checked = unchecked(session, proofs, why_unproved(input, options));
  mark_left_out(left_out, not_checked);
  const bool raised = options.warnings_as_errors && raise_warnings(session);
  ExitStatus found = status_of_findings(session);
  if (raised && found == ExitStatus::all_hold) found = ExitStatus::wrong_specification;
  const bool wrong = found != ExitStatus::all_hold;
  report_unmet(proofs, options.explain || options.format != Format::text, session);
  if (options.require_verdicts && !wrong) report_unchecked(not_checked, session);

  const ExitStatus status = wrong          ? found
                            : !input.whole ? ExitStatus::not_met
                                           : status_of(proofs, not_checked, options);
  const bool any_verdict = has_verdicts(proofs);
  if (options.format == Format::json) {
    console.out << json(proofs, not_checked, session, options.statistics);
  } else if (options.format == Format::sarif) {
    console.out << sarif(
        session, not_checked, options.require_verdicts, any_verdict, status,
        options.limits.analysis == analyzer::AnalysisChoice::half_open ? half_open_text : "");
  } else if (options.format == Format::junit) {
    console.out << junit(proofs, not_checked, options.require_verdicts, session);
  } else {
    show_findings(session, console);
    if (!wrong) say_what_was_not_checked(not_checked, any_verdict, options.without_times, console.err);
    if (!options.quiet) {
      std::ostringstream table;
      write_table(proofs, options.explain, table);
      if (!wrong) write_unchecked(not_checked, table);
      console.out << (console.colour_out ? coloured_table(table.str()) : table.str());
    }
  }
  if (options.statistics && options.format == Format::text) write_statistics(proofs, console.err);
  if (!options.witness.empty() && wrong) {
    console.err << "pal: no witnesses were written, since nothing was proved; if there is a file "
                << options.witness << ", it is of an earlier check\n";
  } else if (!options.witness.empty()) {
    if (const auto problem = write_witnesses(options.witness, proofs, session)) {
      console.err << "pal: " << *problem << "\n";
      return ExitStatus::usage;
    }
  }
  return status;
}

}  // namespace pal::program
