#include "programs/pal/options/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ostream>

#include "pal/support/nearest.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/options/shared_options.hpp"
#include "programs/pal/options/subcommands.hpp"

namespace pal::program {
namespace {

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
  app.footer(statuses_of_proofs);

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
  add_fmt(app, format_options);
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

}  // namespace pal::program
