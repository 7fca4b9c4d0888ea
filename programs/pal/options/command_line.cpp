#include "programs/pal/options/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <ostream>

#include "pal/support/nearest.hpp"
#include "programs/pal/commands/commands.hpp"
#include "programs/pal/options/completion.hpp"
#include "programs/pal/options/shared_options.hpp"
#include "programs/pal/options/steady_help.hpp"
#include "programs/pal/options/subcommands.hpp"

namespace pal::program {
namespace {

ExitStatus run_operation(const CLI::App& operation, const OperationOptions& check,
                         const OperationOptions& tell, const OperationOptions& skeleton,
                         const OperationOptions& format, const Console& console) {
  if (operation.got_subcommand("check")) return check_operation(check, console);
  if (operation.got_subcommand("storyboard")) return tell_operation(tell, console);
  if (operation.got_subcommand("skeleton")) return skeleton_of_operation(skeleton, console);
  return format_operation(format, console);
}

/// The options of the innermost command that was given.
std::vector<std::string> options_of(CLI::App& app) {
  CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().back();
  std::vector<std::string> names;
  for (const CLI::Option* option : command->get_options(std::function<bool(CLI::Option*)>()))
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// Says what is meant by an option that there is not, if that is plain.
void suggest_options(CLI::App& app, const std::vector<std::string>& arguments, std::ostream& err) {
  const std::vector<std::string> known = options_of(app);
  for (const std::string& argument : arguments) {
    if (argument == "--") return;
    if (!argument.starts_with("--")) continue;
    const std::string name = argument.substr(0, argument.find('='));
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    if (const auto close = nearest(name, known)) err << "hint: did you mean '" << *close << "'?\n";
  }
}

/// `help`, and `help COMMAND …`, as the option --help has it.
std::vector<std::string> without_help_command(std::vector<std::string> arguments) {
  if (arguments.empty() || arguments.front() != "help") return arguments;
  arguments.erase(arguments.begin());
  arguments.emplace_back("--help");
  return arguments;
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

ExitStatus run(const std::vector<std::string>& given, const Console& console) {
  const std::vector<std::string> arguments = without_help_command(given);
  CLI::App app{"PAL: robot skills that meet their deadlines, proved", "pal"};
  app.formatter(std::make_shared<SteadyHelp>());
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
  SweepOptions sweep_options;
  add_sweep(app, sweep_options);
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
  LanguageServerOptions language_server_options;
  add_language_server(app, language_server_options);
  OperationOptions operation_check, operation_tell, operation_skeleton, operation_format;
  add_operation(app, operation_check, operation_tell, operation_skeleton, operation_format);

  std::string shell;
  add_completion(app, shell);

  if (!is_known_command(app, arguments, console.err)) return ExitStatus::usage;
  try {
    std::vector<std::string> reversed(arguments.rbegin(), arguments.rend());
    app.parse(reversed);
  } catch (const CLI::ParseError& error) {
    const int status = app.exit(error, console.out, console.err);
    if (status != 0) suggest_options(app, arguments, console.err);
    return status == 0 ? ExitStatus::all_hold : ExitStatus::usage;
  }
  if (app.got_subcommand("check")) return check(check_options, console);
  if (app.got_subcommand("sweep")) return sweep(sweep_options, console);
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
    return run_operation(*app.get_subcommand("operation"), operation_check, operation_tell,
                         operation_skeleton, operation_format, console);
  if (app.got_subcommand("completion")) {
    console.out << completion_script(app, shell);
    return ExitStatus::all_hold;
  }
  if (app.got_subcommand("language-server")) return serve_editor(language_server_options, console);
  if (app.got_subcommand("explain")) return explain_code(explain_options, console);
  return generate(generate_options, console);
}

}  // namespace pal::program
