// pal atc: the run of a requirement as a chart.
#include <fmt/format.h>

#include <algorithm>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "analyzer/chart/chart.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/reports/chart_book.hpp"
#include "programs/pal/reports/proof_chart.hpp"
#include "programs/pal/session/interruption.hpp"
#include "programs/pal/session/write.hpp"

namespace pal::program {
namespace {

struct Chosen {
  const Proof* proof = nullptr;
  std::size_t index = 0;
  ShownRun shown;
};

std::optional<Chosen> with_run(const Proof& proof, std::size_t index) {
  auto shown = shown_run(proof, index);
  return shown ? std::optional(Chosen{&proof, index, std::move(*shown)}) : std::nullopt;
}

bool ended(const std::vector<Proof>& proofs) {
  return std::any_of(proofs.begin(), proofs.end(), [](const Proof& proof) { return proof.ended; });
}

/// The requirement that was named, or the most interesting one; says why there is none.
std::optional<Chosen> choose(const std::vector<Proof>& proofs, const std::string& name, std::ostream& err) {
  std::optional<Chosen> best;
  bool named = false;
  for (const Proof& proof : proofs) {
    for (std::size_t i = 0; i < proof.analysis.verdicts.size(); ++i) {
      const analyzer::Verdict& verdict = proof.analysis.verdicts[i];
      if (name.empty() || verdict.requirement != name) continue;
      named = true;
      if (!best) best = with_run(proof, i);
    }
    if (!name.empty() || best) continue;
    if (const auto index = most_interesting(proof)) best = with_run(proof, *index);
  }
  if (best) return best;
  if (!name.empty() && !named) {
    err << fmt::format("pal: no requirement is called '{}'; there is", name);
    for (const Proof& proof : proofs) {
      for (const auto& verdict : proof.analysis.verdicts) err << " '" << verdict.requirement << "'";
    }
    err << "\n";
  } else if (ended(proofs)) {
    err << "pal: --timeout or Ctrl-C ended the search before there was a run to draw\n";
  } else if (named) {
    err << fmt::format(
        "pal: '{}' has no run to draw: a load is not attained in one run, and what never happens, or is "
        "undecided and not seen in a run with the worst times, has none\n",
        name);
  } else {
    err << "pal: no requirement has a worst run to draw\n";
  }
  return std::nullopt;
}

std::string trace_text(const trace::Trace& run, bool chrome) {
  std::ostringstream text;
  chrome ? trace::write_chrome(run, text) : trace::write_json(run, text);
  return text.str();
}

/// The trace in `path`; says why it cannot be had.
std::optional<trace::Trace> read_trace(const std::string& path, const Console& console) {
  const auto content = read_runs(path, console);
  if (!content) return std::nullopt;
  try {
    std::istringstream in(*content);
    return trace::read_json(in);
  } catch (const std::runtime_error& error) {
    console.err << fmt::format("pal: '{}' is no trace: {}\n", path, error.what());
    return std::nullopt;
  }
}

bool is_of(const trace::Trace& measured, const Proof& proof, const AtcOptions& options,
           const Console& console) {
  if (measured.skill == proof.problem.skill) return true;
  console.err << fmt::format("pal: '{}' is a run of '{}', not of '{}'\n", options.measured, measured.skill,
                             proof.problem.skill);
  return false;
}

/// What the name of the output says of its form is what is written. Otherwise says so.
bool fits_its_name(const std::string& output, ChartFormat format, std::ostream& err) {
  const bool page = output.ends_with(".html") || output.ends_with(".htm");
  for (const char* ending :
       {".png", ".pdf", ".jpg", ".jpeg", ".gif", ".eps", ".ps", ".webp", ".json", ".txt", ".md"}) {
    if (!output.ends_with(ending)) continue;
    const std::string stem = output.substr(0, output.rfind('.'));
    err << fmt::format("pal: cannot write {}: a chart is SVG or HTML\nhint: write -o {}.svg", output, stem);
    if (output.ends_with(".png")) err << fmt::format(", then rsvg-convert -o {} {}.svg", output, stem);
    if (output.ends_with(".pdf")) err << fmt::format(", then rsvg-convert -f pdf -o {} {}.svg", output, stem);
    err << "\n";
    return false;
  }
  if (page == (format == ChartFormat::html) || (!page && !output.ends_with(".svg"))) return true;
  err << fmt::format("pal: cannot write {}: --format {} writes {}\n", output, page ? "svg" : "html",
                     page ? "a picture, SVG" : "a page, HTML");
  return false;
}

}  // namespace

ExitStatus draw_atc(const AtcOptions& given, const Console& console) {
  AtcOptions options = given;
  const bool page = options.output.ends_with(".html") || options.output.ends_with(".htm");
  if (options.format == ChartFormat::by_name) options.format = page ? ChartFormat::html : ChartFormat::svg;
  if (!fits_its_name(options.output, options.format, console.err)) return ExitStatus::usage;
  Session session;
  const Interruption interruption;  // till all is written
  limit_checks(options.limits, session);
  const bool chosen = read(options.selection, console, session);
  std::vector<std::string> inputs = inputs_of(session);
  if (!options.measured.empty()) inputs.push_back(options.measured);
  if (!may_write({options.output, options.trace}, inputs, console)) return ExitStatus::usage;
  std::vector<Proof> proofs;
  if (chosen && !session.diagnostics.has_errors()) proofs = prove(session, options.limits);
  const ExitStatus found = status_of_findings(session);
  for (const Proof& proof : proofs) {
    if (proof.analysis.zeno_run) report_zeno_run(proof.problem, *proof.analysis.zeno_run, session);
  }
  show_findings(session, console);
  if (!chosen) return ExitStatus::usage;
  if (found != ExitStatus::all_hold) return found;
  if (session.specification.environments.empty()) {
    console.err << "pal: a chart needs times: give an environment with --environment FILE\n";
    return ExitStatus::usage;
  }
  auto what = choose(proofs, options.requirement, console.err);
  if (!what) return ended(proofs) ? ExitStatus::not_met : ExitStatus::usage;
  std::optional<trace::Trace> measured;
  if (!options.measured.empty()) {
    measured = read_trace(options.measured, console);
    if (!measured || !is_of(*measured, *what->proof, options, console)) return ExitStatus::usage;
  }
  if (options.no_list) what->shown.options.explanation.clear();
  what->shown.options.narrow = options.narrow;
  const std::string& skill = what->proof->problem.skill;
  const std::string& requirement = what->proof->problem.requirements[what->index].name;
  std::string path = options.output;
  std::string picture;
  if (options.format == ChartFormat::html) {
    if (path.empty()) path = skill + ".html";
    picture = analyzer::chart::html(book_of(proofs, *what->proof, what->index, measured));
  } else {
    if (path.empty()) path = skill + "." + requirement + ".svg";
    picture = measured
                  ? overlay_chart(*what->proof, what->index, *measured, options.narrow)
                  : analyzer::chart::svg(analyzer::chart::timeline(what->shown.run), what->shown.options);
  }
  std::vector<OutputFile> files{{path, std::move(picture)}};
  if (!options.trace.empty()) files.push_back({options.trace, trace_text(what->shown.run, options.chrome)});
  return write_and_list(files, inputs, console);
}

}  // namespace pal::program
