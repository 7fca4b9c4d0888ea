#include "pal/driver/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <functional>
#include <ostream>

#include "analyzer/run_checker/check_run.hpp"
#include "pal/driver/commands.hpp"
#include "pal/driver/private/option_values.hpp"
#include "pal/support/nearest.hpp"

namespace pal::driver {
namespace {

const char* const statuses =
    "Exit status: 0 all requirements hold; 1 the specification is wrong; 2 bad usage, or a file could not be "
    "read or "
    "written; 3 some requirement fails or is undecided.";

const char* const statuses_of_what_if =
    "Exit status: 0 all requirements hold as things are, or with --set and --place as asked for; 1 the "
    "specification is wrong; 2 bad usage, or a file could not be read or written; 3 some requirement fails "
    "or is "
    "undecided, also if a change would mend it, or the time that --timeout gives ended the search.";

// Of commands that prove nothing, or to which what they prove is no finding.
const char* const statuses_of_results =
    "Exit status: 0 done; 1 the specification is wrong; 2 bad usage, or a file could not be read or written.";

void add_max_errors(CLI::App& command, std::size_t& most) {
  command.add_option("--max-errors", most, "how many findings to show, errors before warnings; 0: all")
      ->type_name("N")
      ->capture_default_str()
      ->check(whole_number());
}

void add_selection(CLI::App& command, Selection& selection) {
  command.add_option("files", selection.files, "PAL files with the skills")->required()->type_name("FILE");
  command
      .add_option("-e,--environment", selection.environments, "PAL file with an environment; may be repeated")
      ->type_name("FILE")
      ->take_all();
  command.add_option("-s,--skill", selection.skill, "only the skill of this name")->type_name("NAME");
  command.add_option("--environment-name", selection.environment, "only the environment of this name")
      ->type_name("NAME");
  add_max_errors(command, selection.max_errors);
}

const char* const usual_timeout =
    "give up after so long (undecided): 90 s, 2min, 500ms; a number alone is seconds, 0: never";

void add_limits(CLI::App& command, ProofLimits& limits, const char* timeout = usual_timeout) {
  command
      .add_option("--max-states", limits.max_states, "give up a requirement after so many states (undecided)")
      ->capture_default_str()
      ->check(whole_number());
  add_timeout(command, limits.seconds, timeout);
  command.add_option("--threads", limits.threads, "number of threads; 0: one for each core")
      ->capture_default_str()
      ->check(whole_number())
      ->check(CLI::Range(0U, 1'000U));
}

void add_format(CLI::App& command, Format& format) {
  add_choice<Format>(command, "--format", format, {{"text", Format::text}, {"json", Format::json}},
                     "text or json")
      ->type_name("FORMAT");
}

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
       {"thorough", Choice::thorough},
       {"auto", Choice::automatic}},
      "auto (what decides soonest), thorough (the same, and on until bounds are exact), exact, or "
      "compositional (bounds, however large the skill)")
      ->type_name("ANALYSIS");
  add_choice<Format>(
      *command, "--format", options.format,
      {{"text", Format::text}, {"json", Format::json}, {"sarif", Format::sarif}, {"junit", Format::junit}},
      "text, json, sarif (2.1.0) or junit (XML)")
      ->type_name("FORMAT");
  add_choice<Stage>(*command, "--emit", options.emit, {{"tree", Stage::tree}, {"pan", Stage::pan}},
                    "also print what stands between two stages: tree or pan")
      ->type_name("STAGE");
  command->add_option("--witness", options.witness, "write the run that shows each bound, for pal replay")
      ->type_name("FILE");
  command
      ->add_option("--measured", options.selection.measured,
                   "PAL file with measured times, to compare with the environment's; may be repeated")
      ->type_name("FILE")
      ->take_all();
  auto* explain = command->add_flag("--explain", options.explain, "print what adds up to each bound");
  command->add_flag("--quiet", options.quiet, "print only findings, and nothing if all holds")
      ->excludes(explain);
  command->add_flag("--statistics", options.statistics,
                    "print states, classes, seconds and peak memory of each requirement and of all");
  command->footer(statuses);
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
            if (options.until.count() > analyzer::rules::latest_instant)
              throw CLI::ValidationError("--until", "a run is no longer than 4000000000 s");
          },
          "length of a run in its own time, unless the skill completes before (10 s)")
      ->type_name("DURATION")
      ->excludes(script);
  add_timeout(*command, options.seconds,
              "make no more runs after so long: 90 s, 2min, 500ms; a number alone is seconds, 0: never");
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
      "end after so long, with what is known by then: 90 s, 2min, 500ms; a number alone is seconds, 0: "
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

void add_pan(CLI::App& app, PanOptions& options) {
  CLI::App* command = app.add_subcommand("pan", "Draws modules as Process Activity Networks");
  add_selection(*command, options.selection);
  command->add_option("-m,--module", options.module, "only this module")->type_name("NAME");
  command->add_option("-o,--output", options.output, "folder for SKILL.MODULE.pan.svg")
      ->type_name("FOLDER")
      ->capture_default_str();
  command->add_flag("--dot", options.dot, "write Graphviz DOT instead of SVG");
  command->add_flag("--letters", options.letters,
                    "statements as letters and conditions as c1, c2, … with a key");
  command->add_flag("--pal", options.pal,
                    "print the modules as PAL instead, also those drawn as DOT (FILE.dot)");
  command->footer(statuses_of_results);
}

void add_atc(CLI::App& app, AtcOptions& options) {
  CLI::App* command =
      app.add_subcommand("atc", "Draws the activity timing chart of a requirement's worst run");
  add_selection(*command, options.selection);
  add_limits(*command, options.limits);
  add_choice<ChartFormat>(*command, "--format", options.format,
                          {{"svg", ChartFormat::svg}, {"html", ChartFormat::html}},
                          "svg, a picture; or html, a page to move in, with all requirements and runs")
      ->type_name("FORMAT");
  command
      ->add_option("-r,--requirement", options.requirement,
                   "the requirement; without it the first that fails, else the tightest")
      ->type_name("NAME");
  command
      ->add_option("-o,--output", options.output,
                   "the picture (SKILL.REQUIREMENT.svg), or the page (SKILL.html)")
      ->type_name("FILE");
  command
      ->add_option("--measured", options.measured,
                   "lay the run of this trace over the proved one; in a page it is one of the runs")
      ->type_name("FILE");
  command->add_option("--trace", options.trace, "also write the worst run as a trace")->type_name("FILE");
  command->add_flag("--chrome", options.chrome,
                    "write the trace in Chrome's trace-event form, as Perfetto opens it");
  command->footer(statuses_of_results);
}

void add_generate(CLI::App& app, GenerateOptions& options) {
  CLI::App* command = app.add_subcommand("generate", "Writes the C++ of a skill in an environment");
  add_selection(*command, options.selection);
  command->add_option("-o,--output", options.output, "folder for the files")
      ->type_name("FOLDER")
      ->capture_default_str();
  command->add_option("--depfile", options.depfile, "also write a make rule with every file that was read")
      ->type_name("FILE");
  command
      ->add_option("--depfile-target", options.depfile_target,
                   "target of that rule; without it, the files written")
      ->type_name("FILE");
  add_limits(*command, options.limits);
  command->add_flag("--allow-failing", options.allow_failing, "prove nothing, and always generate");
  command->add_flag("--debug-lines", options.debug_lines, "make debuggers show the lines of PAL (#line)");
  command->add_flag("--explain", options.explain,
                    "write nothing: list processors, threads, servers, couriers and channels");
  command->footer(
      "Exit status: 0 done; 1 the specification is wrong; 2 bad usage, or a file could not be read or "
      "written; 3 "
      "some requirement fails or is undecided, and nothing was written.");
}

void add_format(CLI::App& app, FormatOptions& options) {
  CLI::App* command = app.add_subcommand("fmt", "Gives PAL files their canonical layout");
  add_max_errors(*command, options.max_errors);
  command->add_option("paths", options.paths, "PAL files, folders with them, or - (standard input to output)")
      ->required()
      ->type_name("FILE|FOLDER");
  auto* check =
      command->add_flag("--check", options.check, "write nothing, list the files that would change");
  command->add_flag("--diff", options.diff, "with --check: also show what would change")->needs(check);
  command->footer(
      "Exit status: 0 done, or nothing would change; 1 a syntax error, or something would change; "
      "2 bad usage, or a file could not be read or written.");
}

void add_sequence(CLI::App& app, SequenceOptions& options) {
  CLI::App* command =
      app.add_subcommand("sequence", "Draws the runs into deadlocks as message sequence charts");
  add_selection(*command, options.selection);
  command->add_option("-o,--output", options.output, "folder for SKILL.N.sequence.svg")
      ->type_name("FOLDER")
      ->capture_default_str();
  command->footer(statuses_of_results);
}

void add_resources(CLI::App& app, ResourcesOptions& options) {
  CLI::App* command =
      app.add_subcommand("resources", "Lists what skills need, and what environments lack of it");
  add_selection(*command, options.selection);
  add_format(*command, options.format);
  command->footer(
      "Exit status: 0 nothing is missing; 1 something is, or the specification is wrong; 2 bad usage, or a "
      "file could "
      "not be read.");
}

void add_doc(CLI::App& app, DocOptions& options) {
  CLI::App* command = app.add_subcommand("doc", "Writes the templates of skills as documents");
  command->add_option("files", options.selection.files, "PAL files with the skills")
      ->required()
      ->type_name("FILE");
  command->add_option("-s,--skill", options.selection.skill, "only the skill of this name")
      ->type_name("NAME");
  command->add_option("--format", options.format, "md or html; without it by the name of the output, else md")
      ->check(CLI::IsMember({"md", "html"}))
      ->type_name("FORMAT");
  command->add_option("-o,--output", options.output, "the document; its drawings are written beside it")
      ->type_name("FILE");
  command->footer(statuses_of_results);
}

void add_explain(CLI::App& app, ExplainOptions& options) {
  CLI::App* command = app.add_subcommand("explain", "Explains findings: what they mean, an example, a cure");
  command->add_option("codes", options.codes, "codes, such as PAL0101")->type_name("CODE");
  command->add_flag("--list", options.list, "list all codes, with severity and title");
  command->add_flag("--all", options.all, "print every page, as one Markdown document");
  command->footer("Exit status: 0 explained; 2 no such code.");
}

void add_operation_files(CLI::App& command, OperationOptions& options) {
  command.add_option("files", options.files, "operations, .op.json")->required()->type_name("FILE");
  command
      .add_option("--skills", options.skills, "PAL files with the cell's skills, or folders with such files")
      ->type_name("FILE|FOLDER")
      ->take_all();
  add_max_errors(command, options.max_errors);
}

void add_operation(CLI::App& app, OperationOptions& check, OperationOptions& tell, OperationOptions& format) {
  CLI::App* operation =
      app.add_subcommand("operation", "Checks, tells and formats operations: connected skills");
  operation->require_subcommand(1);

  CLI::App* command = operation->add_subcommand("check", "Finds what is wrong, and how long each way takes");
  add_operation_files(*command, check);
  command->add_option("-e,--environment", check.environments, "PAL file with the cell; may be repeated")
      ->type_name("FILE")
      ->take_all();
  command->add_option("--location", check.locations, "a location that is taught; may be repeated")
      ->type_name("NAME")
      ->take_all();
  command->add_option("--sensor", check.sensors, "a sensor that the cell has; may be repeated")
      ->type_name("NAME")
      ->take_all();
  add_limits(*command, check.limits);
  add_choice<Format>(*command, "--format", check.format,
                     {{"text", Format::text}, {"json", Format::json}, {"sarif", Format::sarif}},
                     "text, json or sarif (2.1.0)")
      ->type_name("FORMAT");
  command->footer(
      "Exit status: 0 nothing is wrong; 1 the operation, or a skill, is; 2 bad usage, or a file could not be "
      "read; 3 some requirement of a skill fails or is undecided.");

  command = operation->add_subcommand("storyboard", "Tells an operation as a story, with pictures");
  add_operation_files(*command, tell);
  command
      ->add_option("-o,--output", tell.output, "the document, .html or .md; without it Markdown is printed")
      ->type_name("FILE");
  command->add_option("--run", tell.run, "also tell the run of this log (workcell operation run --log)")
      ->type_name("LOG");
  command->footer(statuses_of_results);

  command =
      operation->add_subcommand("format", "Gives operations their canonical form: one icon in each line");
  command->add_option("files", format.files, "operations, .op.json")->required()->type_name("FILE");
  command->add_flag("--check", format.check, "write nothing, list the files that would change");
  command->footer(
      "Exit status: 0 done, or nothing would change; 1 a file is wrong, or would change; 2 bad usage, or a "
      "file could not be read or written.");
}

ExitStatus run_operation(const CLI::App& operation, const OperationOptions& check,
                         const OperationOptions& tell, const OperationOptions& format,
                         const Console& console) {
  if (operation.got_subcommand("check")) return check_operation(check, console);
  if (operation.got_subcommand("storyboard")) return tell_operation(tell, console);
  return format_operation(format, console);
}

/// Says which commands there are, if the first argument is meant as one and is none.
bool is_known_command(CLI::App& app, const std::vector<std::string>& arguments, std::ostream& err) {
  if (arguments.empty() || arguments.front().find('-') == 0) return true;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), arguments.front()) != names.end()) return true;
  err << "pal: there is no command '" << arguments.front() << "'; there is";
  for (const std::string& name : names) err << (&name == &names.front() ? " " : ", ") << name;
  const auto close = nearest(arguments.front(), names);
  err << (close ? "\nhint: did you mean '" + *close + "'?\n" : "\nhint: pal --help says what they do\n");
  return false;
}

}  // namespace

ExitStatus run(const std::vector<std::string>& arguments, const Console& console) {
  CLI::App app{"PAL: robot skills that meet their deadlines, proved", "pal"};
  app.set_version_flag("--version", "pal " PAL_VERSION);
  app.require_subcommand(1);
  app.footer(statuses);

  CheckOptions check_options;
  PanOptions pan_options;
  AtcOptions atc_options;
  GenerateOptions generate_options;
  ReplayOptions replay_options;
  FormatOptions format_options;
  DocOptions doc_options;
  ExplainOptions explain_options;
  SequenceOptions sequence_options;
  ResourcesOptions resources_options;
  add_check(app, check_options);
  add_replay(app, replay_options);
  SimulateOptions simulate_options;
  add_simulate(app, simulate_options);
  WhatIfOptions what_if_options;
  add_what_if(app, what_if_options);
  add_pan(app, pan_options);
  add_atc(app, atc_options);
  add_generate(app, generate_options);
  add_format(app, format_options);
  add_doc(app, doc_options);
  add_explain(app, explain_options);
  add_sequence(app, sequence_options);
  add_resources(app, resources_options);
  OperationOptions operation_check, operation_tell, operation_format;
  add_operation(app, operation_check, operation_tell, operation_format);

  if (!is_known_command(app, arguments, console.err)) return ExitStatus::usage;
  try {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    app.parse(reversed);
  } catch (const CLI::ParseError& error) {
    const int status = app.exit(error, console.out, console.err);
    return status == 0 ? ExitStatus::all_hold : ExitStatus::usage;
  }
  if (app.got_subcommand("check")) return check(check_options, console);
  if (app.got_subcommand("replay")) return replay(replay_options, console);
  if (app.got_subcommand("simulate")) return simulate(simulate_options, console);
  if (app.got_subcommand("whatif")) return what_if(what_if_options, console);
  if (app.got_subcommand("pan")) return draw_pan(pan_options, console);
  if (app.got_subcommand("atc")) return draw_atc(atc_options, console);
  if (app.got_subcommand("fmt")) return format(format_options, console);
  if (app.got_subcommand("sequence")) return draw_sequences(sequence_options, console);
  if (app.got_subcommand("resources")) return show_resources(resources_options, console);
  if (app.got_subcommand("doc")) return write_doc(doc_options, console);
  if (app.got_subcommand("operation"))
    return run_operation(*app.get_subcommand("operation"), operation_check, operation_tell, operation_format,
                         console);
  if (app.got_subcommand("explain")) return explain_code(explain_options, console);
  return generate(generate_options, console);
}

}  // namespace pal::driver
