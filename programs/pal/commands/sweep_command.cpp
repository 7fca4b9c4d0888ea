// pal sweep: a study of many proofs, as a table, a page and pictures.
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <sstream>

#include "pal/support/nearest.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/session/interruption.hpp"
#include "programs/pal/session/memory.hpp"
#include "programs/pal/session/write.hpp"
#include "programs/pal/studies/engines.hpp"
#include "programs/pal/studies/study_charts.hpp"
#include "study/cells.hpp"
#include "study/plots.hpp"

namespace pal::program {
namespace {

void say(const study::Refusal& refusal, const std::string& path, std::ostream& err) {
  err << "pal: " << path;
  if (refusal.line > 0) err << ":" << refusal.line;
  err << ": " << refusal.what << "\n";
  if (!refusal.hint.empty()) err << "hint: " << refusal.hint << "\n";
}

std::optional<study::Study> read_study_file(const SweepOptions& options, const Console& console) {
  const auto text = console.files.read(options.study);
  if (const auto* error = std::get_if<FileError>(&text)) {
    console.err << "pal: cannot read '" << options.study << "': " << error->reason << "\n";
    return std::nullopt;
  }
  auto study = study::read_study(std::get<std::string>(text));
  if (const auto* refusal = std::get_if<study::Refusal>(&study)) {
    say(*refusal, options.study, console.err);
    return std::nullopt;
  }
  return std::get<study::Study>(std::move(study));
}

/// Grouped, so that a billion is seen to be one.
std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(digits.size()) - 3; at > 0; at -= 3)
    digits.insert(static_cast<std::size_t>(at), " ");
  return digits;
}

/// The proofs, if they are not too many.
std::optional<std::uint64_t> count(const study::Study& study, std::uint64_t pairs,
                                   const SweepOptions& options, std::ostream& err) {
  const auto points = study::count_points(study);
  std::uint64_t proofs = 0;
  const bool countable = points && !__builtin_mul_overflow(*points, pairs, &proofs);
  if (countable && proofs <= options.most) return proofs;
  std::string sizes;
  for (const study::Figure& figure : study.figures)
    sizes += (sizes.empty() ? "" : " x ") + grouped(figure.choices.size()) + " of " + figure.name;
  study::Refusal refusal;
  refusal.what = "the study has " + (countable ? grouped(proofs) : "more than 10^19") + " proofs, " + sizes +
                 (pairs > 1 ? ", for " + std::to_string(pairs) + " skills and environments" : "") +
                 "; at most " + grouped(options.most) + " are begun";
  refusal.hint = "give fewer values, or pick some of a range: random = 20, seed = 1; --most N allows more";
  say(refusal, options.study, err);
  return std::nullopt;
}

template <class Thing, class NameOf>
std::optional<study::Refusal> keep_named(std::vector<Thing>& things, const std::vector<std::string>& names,
                                         const char* kind, const NameOf& name_of) {
  if (names.empty()) return std::nullopt;
  std::vector<std::string> known;
  for (const Thing& thing : things) known.push_back(name_of(thing));
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const auto close = nearest(name, known);
    std::string list;
    for (const std::string& each : known) list += (list.empty() ? "; there is '" : ", '") + each + "'";
    return study::Refusal{0, std::string("no ") + kind + " is called '" + name + "'" + list,
                          close ? "did you mean '" + *close + "'?" : ""};
  }
  std::erase_if(things, [&](const Thing& thing) {
    return std::find(names.begin(), names.end(), name_of(thing)) == names.end();
  });
  return std::nullopt;
}

/// Reads and checks what the study names, and keeps what it chooses. Says what is wrong.
ExitStatus read_specification(const study::Study& study, const SweepOptions& options, const Console& console,
                              Session& session) {
  Selection selection;
  for (const std::string& each : study.files) selection.files.push_back(resolve_path(options.study, each));
  for (const std::string& each : study.environments)
    selection.environments.push_back(resolve_path(options.study, each));
  read(selection, console, session);
  if (session.diagnostics.has_errors()) {
    show_findings(session, console);
    return status_of_findings(session);
  }
  check::Specification& specification = session.specification;
  auto wrong = keep_named(specification.skills, study.skills, "skill",
                          [](const pan::Network& skill) { return skill.skill.name; });
  if (!wrong)
    wrong = keep_named(specification.environments, study.environment_names, "environment",
                       [](const pan::Environment& environment) { return environment.name; });
  if (!wrong) return ExitStatus::all_hold;
  say(*wrong, options.study, console.err);
  return ExitStatus::usage;
}

ProofLimits limits_of(const study::Study& study, unsigned processes) {
  ProofLimits limits;
  limits.max_states = study.max_states;
  limits.seconds = study.seconds;
  limits.threads = 1;
  limits.max_memory = memory_there_is() / 2 / std::max(1U, processes);
  using Choice = analyzer::AnalysisChoice;
  limits.analysis = study.analysis == "exact"           ? Choice::exact
                    : study.analysis == "thorough"      ? Choice::thorough
                    : study.analysis == "compositional" ? Choice::compositional
                                                        : Choice::automatic;
  return limits;
}

/// "100..199": numbers of proofs, ends included. An end beyond the study is cut off.
std::optional<std::pair<std::uint64_t, std::uint64_t>> range_of(const std::string& text) {
  const auto dots = text.find("..");
  std::uint64_t from = 0, to = 0;
  const auto whole = [](const std::string& digits, std::uint64_t& value) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return error == std::errc() && end == digits.data() + digits.size() && !digits.empty();
  };
  if (dots == std::string::npos || !whole(text.substr(0, dots), from) || !whole(text.substr(dots + 2), to) ||
      from > to)
    return std::nullopt;
  return std::pair(from, to);
}

class Sweep {
 public:
  Sweep(const SweepOptions& options, const study::Study& study, const Session& session, StudyProofs& proofs,
        const Console& console)
      : options_(options),
        study_(study),
        session_(session),
        proofs_(proofs),
        console_(console),
        store_(options.cache.empty() ? options.folder + "/proofs" : options.cache) {}

  /// `all`: proofs of the study.
  ExitStatus run(std::uint64_t all) {
    std::uint64_t from = 0, to = all;
    if (!options_.cells.empty()) {
      const auto range = range_of(options_.cells);
      if (!range || range->first >= all) {
        console_.err << "pal: '" << options_.cells << "' is no range of proofs, as 0.." << all - 1 << " is\n";
        return ExitStatus::usage;
      }
      from = range->first;
      to = std::min(all, range->second + 1);
    } else if (const auto wrong = cannot_be_written(options_.folder + "/table.csv")) {
      console_.err << "pal: " << *wrong << "\n";
      return ExitStatus::usage;
    }
    if (const auto wrong = cannot_be_written(store_.folder() + "/00/0.proof")) {
      console_.err << "pal: " << *wrong << "\n";
      return ExitStatus::usage;
    }
    EngineWork work{proofs_, store_, all, {}};
    study::Table table = no_rows(all);
    for (std::uint64_t proof = from; proof < to; ++proof) {
      const auto kept = find(proof);
      if (!kept || (options_.retry && !kept->note.empty()))
        work.missing.push_back(proof);
      else if (work.missing.empty() && options_.cells.empty())
        proofs_.add_rows(proof, kept->proof, kept->note, table);
    }
    if (!options_.cells.empty()) return make_cells(work);
    console_.err << "pal: " << all << " proofs, " << all - work.missing.size() << " of them made before\n";
    if (work.missing.empty()) return write(table);
    const std::size_t damaged = store_.damaged();
    make(work);
    if (Interruption::asked_for()) return stopped(work);
    if (damaged > 0) console_.err << "pal: " << damaged << " kept proofs were damaged, and were made again\n";
    table = table_of(all);
    store_.trim(options_.cache_size);
    return write(table);
  }

 private:
  /// The part of another engine's job.
  ExitStatus make_cells(EngineWork& work) {
    make_by(Engine::cores, work);
    std::erase_if(work.missing, [&work](std::uint64_t proof) { return is_made(proof, work); });
    return work.missing.empty() ? ExitStatus::all_hold : ExitStatus::not_met;
  }

  void make_by(Engine engine, EngineWork& work) {
    EngineOptions how{engine,         options_.jobs,  options_.block, options_.hosts, options_.patience,
                      options_.study, options_.folder};
    for (const std::string& trouble : run_engine(work, how, console_))
      console_.err << "pal: " << trouble << "\n";
  }

  /// A proof that a process died of, or that was lost with a machine, is tried again.
  void make(EngineWork& work) {
    constexpr int rounds = 3;
    for (int round = 0; round < rounds && !work.missing.empty() && !Interruption::asked_for(); ++round) {
      make_by(options_.engine, work);
      std::erase_if(work.missing, [&work](std::uint64_t proof) { return is_made(proof, work); });
    }
  }

  ExitStatus stopped(const EngineWork& work) {
    std::size_t left = 0;
    for (const std::uint64_t proof : work.missing) left += is_made(proof, work) ? 0U : 1U;
    console_.err << "pal: stopped by you; " << work.all - left << " of " << work.all
                 << " proofs are made and kept in " << store_.folder()
                 << "\nhint: the same command goes on from there; no table was written\n";
    return ExitStatus::not_met;
  }

  struct Kept {
    study::KeptProof proof;
    std::string note;  // for its rows
  };

  std::optional<Kept> find(std::uint64_t proof) {
    if (auto kept = store_.find(proofs_.key(proof))) return Kept{std::move(*kept), ""};
    if (auto kept = store_.find(proofs_.limit_key(proof)))
      return Kept{std::move(*kept), "the study's limit of time, or of memory, ended the proof"};
    return std::nullopt;
  }

  /// With room for the rows of that many proofs.
  study::Table no_rows(std::uint64_t proofs) const {
    study::Table table;
    table.rows.reserve(std::min<std::uint64_t>(proofs, 1 << 20));
    table.study = study_;
    table.pairs = proofs_.pair_names();
    return table;
  }

  study::Table table_of(std::uint64_t all) {
    study::Table table = no_rows(all);
    for (std::uint64_t proof = 0; proof < all; ++proof) {
      const auto kept = find(proof);
      if (!kept) ++not_made_;
      proofs_.add_rows(proof, kept ? kept->proof : study::KeptProof{},
                       kept ? kept->note : "no proof was made", table);
    }
    return table;
  }

  ExitStatus write(const study::Table& table) {
    std::ostringstream summary;
    study::write_summary(table, summary);
    const std::string folder = options_.folder + "/";
    std::vector<OutputFile> files{
        {folder + "table.csv", {}, [&table](std::ostream& out) { study::write_csv(table, out); }},
        {folder + "table.json", {}, [&table](std::ostream& out) { study::write_json(table, out); }},
        {folder + "summary.md", summary.str()}};
    for (const study::PlotWish& plot : study_.plots)
      files.push_back({folder + study::plot_name(study_, plot), study::draw(table, plot)});
    std::vector<std::string> inputs = inputs_of(session_);
    inputs.push_back(options_.study);
    const ExitStatus written = write_and_list(files, inputs, console_);
    if (written != ExitStatus::all_hold) return written;
    if (options_.worst_runs) draw_worst_runs(table, proofs_, {options_.jobs, folder + "worst"}, console_);
    return tell(table);
  }

  ExitStatus tell(const study::Table& table) {
    std::size_t good = 0;
    for (const study::Row& row : table.rows) good += row.outcome == study::Outcome::holds ? 1U : 0U;
    console_.out << good << " of " << table.rows.size() << " verdicts: holds\n";
    if (not_made_ > 0)
      console_.err << "pal: " << not_made_ << " proofs were not made; the table says \"not checked\"\n";
    if (not_made_ > 0 || (options_.all_hold && good < table.rows.size())) return ExitStatus::not_met;
    return ExitStatus::all_hold;
  }

  const SweepOptions& options_;
  const study::Study& study_;
  const Session& session_;
  StudyProofs& proofs_;
  const Console& console_;
  study::ProofStore store_;
  std::size_t not_made_ = 0;
};

}  // namespace

ExitStatus sweep(const SweepOptions& given, const Console& console) {
  SweepOptions options = given;
  if (options.folder.empty())
    options.folder = std::filesystem::path(options.study).stem().string() + "-study";
  const auto study = read_study_file(options, console);
  if (!study || !count(*study, 1, options, console.err)) return ExitStatus::usage;
  const Interruption interruption;  // till all is written
  Session session;
  const ExitStatus read = read_specification(*study, options, console, session);
  if (read != ExitStatus::all_hold) return read;
  StudyProofs proofs(*study, session, limits_of(*study, options.jobs > 0 ? options.jobs : cores()));
  if (const auto trouble = proofs.trouble()) {
    say(*trouble, options.study, console.err);
    return ExitStatus::usage;
  }
  const auto all = count(*study, proofs.pairs(), options, console.err);
  if (!all) return ExitStatus::usage;
  if (options.count) {
    console.out << *all << " proofs: " << *study::count_points(*study) << " points, " << proofs.pairs()
                << " skills and environments\n";
    return ExitStatus::all_hold;
  }
  return Sweep(options, *study, session, proofs, console).run(*all);
}

}  // namespace pal::program
