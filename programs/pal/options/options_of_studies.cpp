// Options of pal sweep, and of proofs that are kept.
#include <chrono>

#include "programs/pal/options/option_values.hpp"
#include "programs/pal/options/shared_options.hpp"
#include "programs/pal/options/subcommands.hpp"

namespace pal::program {

void add_cache(CLI::App& command, std::string& folder, std::uint64_t& size) {
  auto* cache =
      command.add_option("--cache", folder, "keep proofs in this folder, and take those that are kept there")
          ->type_name("FOLDER");
  command
      .add_option("--cache-size", size,
                  "what the folder may grow to; the oldest proofs go first: 500MB, 4GB (1GB)")
      ->type_name("SIZE")
      ->transform(CLI::AsSizeValue(false))
      ->needs(cache);
}

void add_sweep(CLI::App& app, SweepOptions& options) {
  CLI::App* command = app.add_subcommand(
      "sweep", "Makes the many proofs of a study, and writes tables, plots and worst runs");
  command->add_option("study", options.study, "the study, TOML")->required()->type_name("STUDY");
  command->add_option("-o,--output", options.folder, "folder for what is written; without it STUDY-study")
      ->type_name("FOLDER");
  add_cache(*command, options.cache, options.cache_size);
  add_choice<Engine>(*command, "--engine", options.engine,
                     {{"cores", Engine::cores}, {"parallel", Engine::parallel}, {"slurm", Engine::slurm}},
                     "cores (of this machine), parallel (GNU parallel, also over ssh) or slurm")
      ->type_name("ENGINE");
  command->add_option("--jobs", options.jobs, "proofs at a time on each machine; 0: one for each core")
      ->capture_default_str()
      ->check(whole_number())
      ->check(CLI::Range(0U, 1'000U));
  command->add_option("--hosts", options.hosts, "machines for GNU parallel, as its --sshloginfile has them")
      ->type_name("FILE");
  command
      ->add_option("--block", options.block,
                   "proofs of one job of parallel or slurm; 0: so many that it takes half a minute")
      ->capture_default_str()
      ->check(whole_number());
  command
      ->add_option_function<std::string>(
          "--patience",
          [&options](const std::string& text) {
            options.patience = std::chrono::duration<double>(duration_of(text, "--patience")).count();
          },
          "give up parallel or slurm if no proof comes for this time (30 min)")
      ->type_name("DURATION");
  command->add_flag("--worst-runs", options.worst_runs, "draw the worst run of each requirement that fails");
  command->add_flag("--all-hold", options.all_hold, "end with 3 unless every verdict is 'holds'");
  command->add_flag("--retry", options.retry, "make proofs again that a limit of time or memory ended");
  command->add_flag("--count", options.count, "say how many proofs the study has, and make none");
  command->add_option("--most", options.most, "refuse a study of more proofs")
      ->capture_default_str()
      ->check(whole_number())
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{4'000'000'000}));
  command
      ->add_option("--cells", options.cells,
                   "make only these proofs, 100..199 of --count, and write no table: for engines")
      ->type_name("A..B");
  command->footer(
      "Exit status: 0 the study is complete, whatever its verdicts, or with --all-hold if all hold; 1 the "
      "specification is wrong; 2 bad usage, a study that makes no sense, or a file could not be read or "
      "written; 3 "
      "some proof was not made, as after Ctrl-C.");
}

}  // namespace pal::program
