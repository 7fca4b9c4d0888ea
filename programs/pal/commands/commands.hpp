// The commands of the program pal, each a function from options to exit status.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analyzer/runs/simulate.hpp"
#include "programs/pal/session/console.hpp"
#include "programs/pal/session/exit_status.hpp"
#include "programs/pal/session/proof.hpp"
#include "programs/pal/session/selection.hpp"
#include "programs/pal/studies/engines.hpp"
#include "study/proof_store.hpp"

namespace pal::program {

enum class Format { text, json, sarif, junit };
/// A value between two stages, to look at.
enum class Stage { none, tree, pan };

struct CheckOptions {
  Selection selection;
  ProofLimits limits;
  Format format = Format::text;
  Stage emit = Stage::none;
  bool explain = false;
  bool quiet = false;               // of what holds nothing is said
  bool without_times = false;       // nothing that needs times is checked, and that is no fault
  bool require_verdicts = false;    // a requirement without a verdict is an error
  bool warnings_as_errors = false;  // a warning is an error
  bool statistics = false;
  std::string witness;        // where to write the witnesses
  std::string changed_since;  // a revision of git; empty: all is proved
  std::string cache;          // folder with kept proofs; empty: none
  std::uint64_t cache_size = study::usual_store_size;
};
ExitStatus check(const CheckOptions& options, const Console& console);

struct SweepOptions {
  std::string study;   // TOML
  std::string folder;  // for results; empty: named after the study
  std::string cache;   // empty: in the folder
  std::uint64_t cache_size = study::usual_store_size;
  Engine engine = Engine::cores;
  unsigned jobs = 0;
  std::uint64_t block = 0;
  std::string hosts;
  double patience = 1800;
  bool worst_runs = false;
  bool all_hold = false;
  bool retry = false;
  bool count = false;
  std::uint64_t most = 1'000'000;  // proofs
  std::string cells;               // "A..B"; empty: all
};
/// Makes a study. all_hold: it is complete.
ExitStatus sweep(const SweepOptions& options, const Console& console);

struct ReplayOptions {
  Selection selection;
  std::string witness;  // a file that check wrote
};
/// Confirms witnesses without the analysis. not_met: some could not be.
ExitStatus replay(const ReplayOptions& options, const Console& console);

struct SimulateOptions {
  Selection selection;
  Format format = Format::text;
  analyzer::SimulationOptions::Times times = analyzer::SimulationOptions::Times::random;
  std::size_t runs = 100;
  std::uint64_t seed = 1;                     // of the first run; each next one has the next
  Duration until = std::chrono::seconds(10);  // of each run at most, in its own time
  double seconds = 0;                         // of all runs together; 0: as long as they take
  std::string script;       // a file that check --witness wrote: its scripts, instead of chance
  std::string requirement;  // of trace and chart; empty: the most interesting
  std::string trace;        // where to write the trace of the run that shows the requirement's value
  bool chrome = false;      // … in the form of trace viewers
  std::string chart;        // where to write its chart
};
/// Makes runs and measures every requirement in them. not_met: one is broken, or a script cannot be followed.
ExitStatus simulate(const SimulateOptions& options, const Console& console);

struct WhatIfOptions {
  Selection selection;
  ProofLimits limits;  // seconds below 0: not given; then slack has usual_seconds_of_slack
  Format format = Format::text;
  std::vector<std::string> changes;  // "NAME = VALUE"; without any, and without place: slack
  std::optional<int> place;          // placements on this many processors; 0: the fewest that do
  bool priorities = false;           // … with every order by priority
  std::string witness;               // where to write a run for each placement that is refuted
};
constexpr double usual_seconds_of_slack = 60;
ExitStatus what_if(const WhatIfOptions& options, const Console& console);

struct PanOptions {
  Selection selection;
  std::string module;  // empty: every module with a body
  std::string output = ".";
  bool dot = false;
  bool pal = false;  // the modules as text, to the output
  bool letters = false;
};
ExitStatus draw_pan(const PanOptions& options, const Console& console);

/// by_name: HTML if the output is called so, else SVG.
enum class ChartFormat { by_name, svg, html };

struct AtcOptions {
  Selection selection;
  ProofLimits limits;
  ChartFormat format = ChartFormat::by_name;
  std::string requirement;  // empty: the most interesting
  std::string output;       // empty: SKILL.REQUIREMENT.svg, or SKILL.html
  std::string measured;     // a trace to lay over, or to be one of the page's runs
  std::string trace;        // where to write the trace of the worst run
  bool chrome = false;      // … in the form of trace viewers
  bool no_list = false;     // the list of what the time is spent on is left out
  bool narrow = false;      // the picture fits a column of a page with two
};
ExitStatus draw_atc(const AtcOptions& options, const Console& console);

struct GenerateOptions {
  Selection selection;
  std::string output = ".";
  std::string depfile;         // a make rule with every text that was read
  std::string depfile_target;  // its target; empty: the files written
  std::string depfile_folder;  // stands before relative paths of texts
  ProofLimits limits;
  bool allow_failing = false;  // nothing is proved
  bool plugin = false;         // also what makes a plug-in of the skill
  std::string declared;        // with plugin: the file of what the skill declares; empty: nothing
  bool debug_lines = false;    // debuggers show lines of PAL
  bool explain = false;        // lists what would be generated, and writes nothing
};
ExitStatus generate(const GenerateOptions& options, const Console& console);

struct FormatOptions {
  std::vector<std::string> paths;               // files, folders, or "-"
  bool check = false;                           // change nothing, list what would change
  bool diff = false;                            // … and show how
  std::size_t max_errors = default_max_errors;  // findings that are shown; 0: all
};
ExitStatus format(const FormatOptions& options, const Console& console);

struct DocOptions {
  Selection selection;
  std::string format;  // md or html; empty: what the output is called
  std::string output;  // empty: console.out
};
/// The templates of skills as documents.
ExitStatus write_doc(const DocOptions& options, const Console& console);

struct ExplainOptions {
  std::vector<std::string> codes;
  bool list = false;  // codes and titles instead
  bool all = false;   // every page, as one document
};
/// Prints the pages on findings.
ExitStatus explain_code(const ExplainOptions& options, const Console& console);

struct LanguageServerOptions {
  std::string log;  // where to write every message; empty: nowhere
};
/// Serves an editor on the standard input and `console.out`.
ExitStatus serve_editor(const LanguageServerOptions& options, const Console& console);

struct SequenceOptions {
  Selection selection;
  std::string output = ".";
};
/// Draws the runs into deadlocks, and those that leave a command undelivered, as message sequence charts.
ExitStatus draw_sequences(const SequenceOptions& options, const Console& console);

struct ResourcesOptions {
  Selection selection;
  Format format = Format::text;
};
/// Prints what each skill needs, and what the environments lack. wrong_specification: something is missing.
ExitStatus show_resources(const ResourcesOptions& options, const Console& console);

struct OperationOptions {
  std::vector<std::string> files;         // .op.json
  std::vector<std::string> skills;        // PAL files, or folders with them
  std::vector<std::string> environments;  // PAL files
  std::string scene;                      // of the workcell, which then tells all that follows; empty: none
  std::vector<std::string> locations;     // those that are taught; empty: not known
  std::vector<std::string> sensors;       // those that the cell has; empty: not known
  std::vector<std::string> figures;       // those that its skills report; empty: not known
  ProofLimits limits;
  Format format = Format::text;
  std::size_t max_errors = default_max_errors;
  std::string output;  // of a storyboard, .html or .md; of skeletons, a folder; empty: to console.out
  std::string run;     // of a storyboard: the log of a run that it tells, too
  bool check = false;  // of the format: change nothing
};
/// Finds what is wrong with operations, what their skills need and the cell lacks, and how long each way
/// takes. The status not_met: a requirement of a skill fails or is undecided.
ExitStatus check_operation(const OperationOptions& options, const Console& console);
/// Tells an operation as a story.
ExitStatus tell_operation(const OperationOptions& options, const Console& console);
/// Writes a PAL file of each skill that the operations only plan. A file that is there is not written over.
ExitStatus skeleton_of_operation(const OperationOptions& options, const Console& console);
/// Gives operations their canonical form.
ExitStatus format_operation(const OperationOptions& options, const Console& console);

}  // namespace pal::program
