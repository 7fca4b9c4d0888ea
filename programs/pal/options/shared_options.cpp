#include "programs/pal/options/shared_options.hpp"

#include "programs/pal/options/option_values.hpp"

namespace pal::program {
namespace {

const char* const usual_timeout =
    "give up after this time (undecided): 90 s, 2min, 500ms; a number alone is seconds, 0: never";

}  // namespace

const char* const statuses_of_proofs =
    "Exit status: 0 all requirements hold; 1 the specification is wrong; 2 bad usage, or a file could not be "
    "read or "
    "written; 3 some requirement fails or is undecided.";

const char* const statuses_of_results =
    "Exit status: 0 done; 1 the specification is wrong; 2 bad usage, or a file could not be read or written.";

void add_max_errors(CLI::App& command, std::size_t& most) {
  command.add_option("--max-errors", most, "how many findings to show, errors before warnings; 0: all")
      ->type_name("N")
      ->capture_default_str()
      ->check(whole_number());
}

void add_selection(CLI::App& command, Selection& selection) {
  command
      .add_option("files", selection.files,
                  "PAL files with the skills, folders with them, or - (standard input)")
      ->required()
      ->type_name("FILE");
  command
      .add_option("-e,--environment", selection.environments,
                  "PAL file, or folder, with an environment; may be repeated")
      ->type_name("FILE")
      ->take_all();
  command.add_option("-s,--skill", selection.skill, "only the skill of this name")->type_name("NAME");
  command.add_option("--environment-name", selection.environment, "only the environment of this name")
      ->type_name("NAME");
  add_max_errors(command, selection.max_errors);
}

void add_limits(CLI::App& command, ProofLimits& limits, const char* timeout) {
  command
      .add_option("--max-states", limits.max_states,
                  "give up a requirement after this many states (undecided)")
      ->capture_default_str()
      ->check(whole_number());
  command
      .add_option(
          "--max-memory", limits.max_memory,
          "explore no further once the program takes so much memory: 500MB, 4GB; without it half of what "
          "the machine, its container or a ulimit gives")
      ->type_name("SIZE")
      ->transform(CLI::AsSizeValue(false));
  add_timeout(command, limits.seconds, timeout == nullptr ? usual_timeout : timeout);
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

}  // namespace pal::program
