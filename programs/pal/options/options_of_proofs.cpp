// Options of the commands that say whether requirements hold.
#include "analyzer/run_checker/check_run.hpp"
#include "programs/pal/options/option_values.hpp"
#include "programs/pal/options/shared_options.hpp"
#include "programs/pal/options/subcommands.hpp"

namespace pal::program {
namespace {

const char* const statuses_of_what_if =
    "Exit status: 0 all requirements hold as things are, or with --set and --place as asked for; 1 the "
    "specification is wrong; 2 bad usage, or a file could not be read or written; 3 some requirement fails "
    "or is "
    "undecided, also if a change would mend it, or the time that --timeout gives ended the search.";

}  // namespace

void add_check(CLI::App& app, CheckOptions& options) {
  CLI::App* command =
      app.add_subcommand("check", "Finds what is wrong, and proves or refutes every requirement");
  add_selection(*command, options.selection);
  add_limits(*command, options.limits);
  using Choice = analyzer::AnalysisChoice;
  options.limits.analysis = Choice::automatic;
  add_choice<Choice>(
      *command, "--analysis", options.limits.analysis,
      {{"exact", Choice::exact},
       {"compositional", Choice::compositional},
       {"half-open", Choice::half_open},
       {"thorough", Choice::thorough},
       {"auto", Choice::automatic}},
      "auto (what decides soonest), thorough (the same, continued until bounds are exact), exact, "
      "compositional (bounds, however large the skill), or half-open (such bounds as textbooks have them: a "
      "job that is released as another ends does not delay it)")
      ->type_name("ANALYSIS");
  add_choice<Format>(
      *command, "--format", options.format,
      {{"text", Format::text}, {"json", Format::json}, {"sarif", Format::sarif}, {"junit", Format::junit}},
      "text, json, sarif (2.1.0) or junit (XML)")
      ->type_name("FORMAT");
  add_choice<Stage>(*command, "--emit", options.emit, {{"tree", Stage::tree}, {"pan", Stage::pan}},
                    "also print an intermediate form: tree or pan")
      ->type_name("STAGE");
  command->add_option("--witness", options.witness, "write the run that shows each bound, for pal replay")
      ->type_name("FILE");
  command
      ->add_option("--measured", options.selection.measured,
                   "PAL file with measured times, to compare with the environment's; may be repeated")
      ->type_name("FILE")
      ->take_all();
  add_cache(*command, options.cache, options.cache_size);
  command
      ->add_option(
          "--changed-since", options.changed_since,
          "prove only skills of which a file, or the environment's, differs from this revision of git")
      ->type_name("REV");
  auto* explain = command->add_flag("--explain", options.explain, "print what adds up to each bound");
  command->add_flag("--quiet", options.quiet, "print only findings, and nothing if all holds")
      ->excludes(explain);
  auto* without_times = command->add_flag("--without-times", options.without_times,
                                          "check everything but times, and prove no requirement");
  command
      ->add_flag("--require-verdicts", options.require_verdicts,
                 "make it an error if a requirement was not checked, or a skill has none")
      ->excludes(without_times);
  command->add_flag("--warnings-as-errors", options.warnings_as_errors, "make each warning an error");
  command->add_flag("--statistics", options.statistics,
                    "print states, classes, seconds and peak memory of each requirement and of all");
  command->footer(statuses_of_proofs);
}

void add_replay(CLI::App& app, ReplayOptions& options) {
  CLI::App* command =
      app.add_subcommand("replay", "Confirms the runs that check --witness wrote, without the analysis");
  command->add_option("witness", options.witness, "file with witnesses")->required()->type_name("WITNESS");
  add_selection(*command, options.selection);
  command->footer(
      "Exit status: 0 all are confirmed; 1 the specification is wrong; 2 bad usage, or a file could not be "
      "read; "
      "3 some witness is refused.");
}

void add_simulate(CLI::App& app, SimulateOptions& options) {
  CLI::App* command = app.add_subcommand(
      "simulate", "Makes random runs, or runs by script, and says what they show of every requirement");
  add_selection(*command, options.selection);
  add_format(*command, options.format);
  using Times = analyzer::SimulationOptions::Times;
  auto* script = command
                     ->add_option("--script", options.script,
                                  "the runs that check --witness wrote, made again from their scripts")
                     ->type_name("FILE");
  add_choice<Times>(*command, "--times", options.times,
                    {{"random", Times::random},
                     {"worst", Times::worst},
                     {"best", Times::best},
                     {"extremes", Times::extremes}},
                    "how long everything takes: random, worst, best, or extremes (best or worst, at random)")
      ->type_name("TIMES")
      ->excludes(script);
  command->add_option("--runs", options.runs, "number of runs")
      ->capture_default_str()
      ->check(CLI::Range(1, 1'000'000))
      ->excludes(script);
  command->add_option("--seed", options.seed, "seed of the first run; the others follow")
      ->capture_default_str()
      ->check(whole_number())
      ->excludes(script);
  command
      ->add_option_function<std::string>(
          "--until",
          [&options](const std::string& text) {
            options.until = duration_of(text, "--until");
            if (options.until.count() > analyzer::run_checker::latest_instant)
              throw CLI::ValidationError("--until", "a run is no longer than 4000000000 s");
          },
          "length of a run in its own time, unless the skill completes before (10 s)")
      ->type_name("DURATION")
      ->excludes(script);
  add_timeout(*command, options.seconds,
              "make no more runs after this time: 90 s, 2min, 500ms; a number alone is seconds, 0: never");
  command
      ->add_option("-r,--requirement", options.requirement,
                   "requirement whose run is written; without it the first that is broken, else the tightest")
      ->type_name("NAME");
  command->add_option("--trace", options.trace, "write the run that shows its value as a trace")
      ->type_name("FILE");
  command->add_flag("--chrome", options.chrome, "… in Chrome's trace-event form, as Perfetto opens it");
  command->add_option("--chart", options.chart, "draw that run as an activity timing chart, SVG")
      ->type_name("FILE");
  command->footer(
      "Runs prove nothing: pal check does. Exit status: 0 no run breaks a requirement; 1 the specification "
      "is "
      "wrong; 2 bad usage, or a file could not be read or written; 3 a run breaks one or leaves one open, or "
      "a "
      "script cannot be followed.");
}

void add_what_if(CLI::App& app, WhatIfOptions& options) {
  CLI::App* command = app.add_subcommand(
      "whatif",
      "Says how much longer everything may take, what mends a requirement that fails, and what other figures "
      "and placements do");
  add_selection(*command, options.selection);
  options.limits.seconds = -1;
  add_limits(
      *command, options.limits,
      "end after this time, with what is known by then: 90 s, 2min, 500ms; a number alone is seconds, 0: "
      "never; without it 60 s for slack and remedies, and no limit for --set and --place");
  add_format(*command, options.format);
  command
      ->add_option("--set", options.changes,
                   "the verdicts with another figure: 'extract-z = 5..7 ms', 'SM1.priority = 3', "
                   "'SM1.processor = P1', 'PROCESSOR P4', 'alter.period = 20 ms'; may be repeated")
      ->type_name("CHANGE")
      ->take_all();
  auto* place =
      command
          ->add_option_function<int>(
              "--place", [&options](int processors) { options.place = processors; },
              "every placement on N processors that meets every requirement; 0: on the fewest that suffice")
          ->type_name("N")
          ->check(CLI::Range(0, 100));
  command->add_flag("--priorities", options.priorities, "also try every order of priorities")->needs(place);
  command->add_option("--witness", options.witness, "write a run for each placement refuted, for pal replay")
      ->type_name("FILE")
      ->needs(place);
  command->footer(statuses_of_what_if);
}

}  // namespace pal::program
