// Options of `pal operation`.
#include "programs/pal/options/option_values.hpp"
#include "programs/pal/options/shared_options.hpp"
#include "programs/pal/options/subcommands.hpp"

namespace pal::program {
namespace {

void add_operation_files(CLI::App& command, OperationOptions& options) {
  command.add_option("files", options.files, "operations, .op.json")->required()->type_name("FILE");
  command
      .add_option("--skills", options.skills, "PAL files with the cell's skills, or folders with such files")
      ->type_name("FILE|FOLDER")
      ->take_all();
  add_max_errors(command, options.max_errors);
}

}  // namespace

void add_operation(CLI::App& app, OperationOptions& check, OperationOptions& tell, OperationOptions& skeleton,
                   OperationOptions& format) {
  CLI::App* operation =
      app.add_subcommand("operation", "Checks, tells and formats operations: connected skills");
  operation->require_subcommand(1);

  CLI::App* command = operation->add_subcommand("check", "Finds what is wrong, and how long each way takes");
  add_operation_files(*command, check);
  command->add_option("-e,--environment", check.environments, "PAL file with the cell; may be repeated")
      ->type_name("FILE")
      ->take_all();
  command->get_option("--skills")->description(
      "PAL files with the cell's skills, or folders with such files; with --scene also built skills, .so, beside "
      "those of the scene");
  auto* scene = command
                    ->add_option("--scene", check.scene,
                                 "a scene of the workcell: with its skills, sensors and locations")
                    ->type_name("SCENE");
  command->add_option("--location", check.locations, "a location that is taught; may be repeated")
      ->type_name("NAME")
      ->take_all();
  command->add_option("--sensor", check.sensors, "a sensor that the cell has; may be repeated")
      ->type_name("NAME")
      ->take_all();
  command->add_option("--figure", check.figures, "a figure that skills of the cell report; may be repeated")
      ->type_name("NAME")
      ->take_all();
  for (const char* known : {"--location", "--sensor", "--figure"})
    scene->excludes(command->get_option(known));
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
      operation->add_subcommand("skeleton", "Writes PAL files to begin with, of skills that are planned");
  command->add_option("files", skeleton.files, "operations, .op.json")->required()->type_name("FILE");
  command->add_option("-o,--output", skeleton.output, "the folder; without it the PAL is printed")
      ->type_name("FOLDER");
  add_max_errors(*command, skeleton.max_errors);
  command->footer(
      "Exit status: 0 written; 1 a file is wrong, or plans no skill; 2 bad usage, or a file could not be "
      "read "
      "or written, or is there already.");

  command =
      operation->add_subcommand("format", "Gives operations their canonical form: one icon in each line");
  command->add_option("files", format.files, "operations, .op.json")->required()->type_name("FILE");
  command->add_flag("--check", format.check, "write nothing, list the files that would change");
  command->footer(
      "Exit status: 0 done, or nothing would change; 1 a file is wrong, or would change; 2 bad usage, or a "
      "file could not be read or written.");
}

}  // namespace pal::program
