// Options of the commands that draw.
#include "programs/pal/options/option_values.hpp"
#include "programs/pal/options/shared_options.hpp"
#include "programs/pal/options/subcommands.hpp"

namespace pal::program {

void add_pan(CLI::App& app, PanOptions& options) {
  CLI::App* command = app.add_subcommand("pan", "Draws modules as Process Activity Networks");
  add_selection(*command, options.selection);
  command->add_option("-m,--module", options.module, "only this module")->type_name("NAME");
  command
      ->add_option("-o,--output", options.output,
                   "folder for SKILL.MODULE.pan.svg; with --module also a file")
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
  auto* no_list = command->add_flag("--no-list", options.no_list,
                                    "leave out the list of what the time is spent on, and its marks");
  command->add_flag("--narrow", options.narrow, "draw a picture for a column of a page with two");
  command
      ->add_option("--measured", options.measured,
                   "lay the run of this trace over the proved one; in a page it is one of the runs")
      ->type_name("FILE")
      ->excludes(no_list);
  command->add_option("--trace", options.trace, "also write the worst run as a trace")->type_name("FILE");
  command->add_flag("--chrome", options.chrome,
                    "write the trace in Chrome's trace-event form, as Perfetto opens it");
  command->footer(statuses_of_results);
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

}  // namespace pal::program
