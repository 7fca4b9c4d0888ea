// Options of the commands that write code and documents, or list what a skill is made of.
#include "programs/pal/options/shared_options.hpp"
#include "programs/pal/options/subcommands.hpp"

namespace pal::program {

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
  command
      ->add_option("--depfile-folder", options.depfile_folder,
                   "stands in that rule before the relative paths of files that were read")
      ->type_name("FOLDER");
  add_limits(*command, options.limits);
  command->add_flag("--allow-failing", options.allow_failing, "prove nothing, and always generate");
  auto* plugin = command->add_flag(
      "--plugin", options.plugin,
      "also write the file that lets programs such as workcell load the skill when they run");
  command
      ->add_option("--declared", options.declared,
                   "with --plugin: what the skill declares to a workcell, such as its longest times")
      ->type_name("FILE")
      ->needs(plugin);
  command->add_flag("--debug-lines", options.debug_lines, "make debuggers show the lines of PAL (#line)");
  command->add_flag("--explain", options.explain,
                    "write nothing: list processors, threads, servers, couriers and channels");
  command->footer(
      "Exit status: 0 done; 1 the specification is wrong; 2 bad usage, or a file could not be read or "
      "written; 3 "
      "some requirement fails or is undecided, and nothing was written.");
}

void add_fmt(CLI::App& app, FormatOptions& options) {
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

void add_language_server(CLI::App& app, LanguageServerOptions& options) {
  CLI::App* command =
      app.add_subcommand("language-server",
                         "Serves an editor by the Language Server Protocol, on standard input "
                         "and output");
  command->add_option("--log", options.log, "write every message to this file")->type_name("FILE");
  command->footer(
      "Exit status: 0 the editor shut it down; 1 the input ended before; 2 bad usage, or the log could "
      "not be written.");
}

}  // namespace pal::program
