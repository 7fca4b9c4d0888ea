#include "programs/pal/studies/job_engines.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <thread>

#include "pal/support/output.hpp"
#include "programs/pal/session/interruption.hpp"
#include "programs/pal/session/process.hpp"
#include "programs/pal/studies/progress.hpp"
#include "study/cores.hpp"
#include "study/proof_key.hpp"

namespace pal::program {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double shortest_job = 30;  // seconds: what a queue takes for a job is little beside that

std::string absolute(const std::string& path) {
  std::error_code error;
  const fs::path made = fs::absolute(path, error);
  return error ? path : made.lexically_normal().string();
}

void forget_those_made(EngineWork& work) {
  std::erase_if(work.missing, [&work](std::uint64_t proof) { return is_made(proof, work); });
}

/// Makes a few proofs here, spread over the study, to learn how long one takes.
std::uint64_t block_by_trial(EngineWork& work, const EngineOptions& options) {
  constexpr std::size_t trials = 8;
  const std::size_t count = std::min(trials, work.missing.size());
  const unsigned processes =
      std::min<unsigned>(options.jobs > 0 ? options.jobs : cores(), static_cast<unsigned>(count));
  const auto begin = Clock::now();
  study::run_on_cores(
      {count,
       processes,
       [&](std::size_t i) { make_proof(work.missing[i * work.missing.size() / count], work); },
       {},
       Interruption::asked_for});
  const double each = std::chrono::duration<double>(Clock::now() - begin).count() * processes /
                      static_cast<double>(std::max<std::size_t>(count, 1));
  constexpr double most = 1e6;
  return static_cast<std::uint64_t>(std::clamp(std::ceil(shortest_job / std::max(each, 1e-6)), 1.0, most));
}

/// The jobs of a study, the same whenever it goes on: their number and size are kept beside the results.
struct Jobs {
  std::string list;  // file with a range each line
  std::string log;   // of GNU parallel
  std::size_t count = 0;
};

Jobs jobs_of(EngineWork& work, const EngineOptions& options, std::uint64_t most_jobs, std::string& trouble) {
  std::string keys;
  for (std::uint64_t proof = 0; proof < work.all; ++proof) keys += work.proofs.key(proof);
  const std::string name = absolute(options.folder) + "/jobs/" + study::sha256(keys).substr(0, 12);
  Jobs jobs{name + ".txt", name + ".log", 0};
  std::ifstream old(jobs.list);
  if (old && options.block == 0) {
    for (std::string line; std::getline(old, line);) ++jobs.count;
    if (jobs.count > 0 && jobs.count <= most_jobs) return jobs;
  }
  std::uint64_t block = options.block > 0 ? options.block : block_by_trial(work, options);
  block = std::max(block, (work.all + most_jobs - 1) / most_jobs);
  std::string text;
  const auto blocks = blocks_of(work.all, block);
  for (const std::string& each : blocks) text += each + "\n";
  jobs.count = blocks.size();
  std::error_code ignored;
  fs::remove(jobs.log, ignored);  // it is of other jobs
  trouble = write_files({{jobs.list, text}}).value_or("");
  return jobs;
}

/// The command of a job, but for its range.
std::vector<std::string> job_command(const EngineWork& work, const EngineOptions& options) {
  return {own_program(), "sweep", absolute(options.study), "--cache", absolute(work.store.folder()),
          "--jobs",      "1"};
}

/// Called again and again while jobs are at work. False once it is time to end.
class Watch {
 public:
  Watch(EngineWork& work, const EngineOptions& options, const Console& console)
      : work_(work), options_(options), all_(work.missing.size()), left_(all_), progress_(all_, console) {}

  bool look() {
    using namespace std::chrono_literals;
    if (Interruption::asked_for()) return false;
    const auto now = Clock::now();
    if (now - looked_ < 2s) return !given_up_;
    looked_ = now;
    forget_those_made(work_);
    if (work_.missing.size() < left_) last_ = now;
    left_ = work_.missing.size();
    progress_.show(all_ - left_);
    given_up_ = std::chrono::duration<double>(now - last_).count() > options_.patience;
    return !given_up_;
  }
  bool given_up() const { return given_up_; }

 private:
  EngineWork& work_;
  const EngineOptions& options_;
  std::size_t all_;
  std::size_t left_;
  Progress progress_;
  Clock::time_point last_ = Clock::now();
  Clock::time_point looked_{};
  bool given_up_ = false;
};

std::string no_proof_for(const EngineOptions& options) {
  return "no proof came for " + about(options.patience) + " (--patience); the jobs were cancelled";
}

}  // namespace

std::vector<std::string> blocks_of(std::uint64_t all, std::uint64_t block) {
  std::vector<std::string> blocks;
  for (std::uint64_t from = 0; from < all; from += block)
    blocks.push_back(std::to_string(from) + ".." + std::to_string(std::min(all, from + block) - 1));
  return blocks;
}

std::string shell_word(const std::string& text) {
  std::string made = "'";
  for (const char c : text) made += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return made + "'";
}

std::vector<std::string> run_by_parallel(EngineWork& work, const EngineOptions& options,
                                         const Console& console) {
  constexpr std::uint64_t most_jobs = 1'000'000;
  std::string trouble;
  const Jobs jobs = jobs_of(work, options, most_jobs, trouble);
  if (!trouble.empty()) return {trouble};
  forget_those_made(work);
  if (work.missing.empty() || Interruption::asked_for()) return {};
  std::vector<std::string> words{"--will-cite", "--quote", "--retries",      "3",
                                 "--joblog",    jobs.log,  "--resume-failed"};
  if (options.jobs > 0) words.insert(words.end(), {"--jobs", std::to_string(options.jobs)});
  if (!options.hosts.empty())
    words.insert(
        words.end(),
        {"--sshloginfile", absolute(options.hosts), "--workdir", fs::current_path().string(), "--ssh",
         "ssh -o BatchMode=yes -o ConnectTimeout=10 -o ServerAliveInterval=5 -o ServerAliveCountMax=3"});
  words.insert(words.end(), {"--arg-file", jobs.list});
  for (std::string& word : job_command(work, options)) words.push_back(std::move(word));
  words.insert(words.end(), {"--cells", "{}"});
  Watch watch(work, options, console);
  const std::string log = jobs.list + ".out";
  const int status = run_and_watch("parallel", words, log, [&watch] { return watch.look(); });
  std::error_code ignored;
  if (!Interruption::asked_for()) {
    forget_those_made(work);
    // It believes its log; what is missing all the same is for new jobs.
    if (!work.missing.empty() && status == 0) fs::remove(jobs.log, ignored);
  }
  if (watch.given_up()) return {no_proof_for(options)};
  if (status < 0 && !Interruption::asked_for())
    return {"GNU parallel did not run to its end: is it installed (Debian: apt-get install parallel)?"};
  if (status > 0 && !work.missing.empty())
    return {"GNU parallel says that " + std::to_string(status) + " jobs failed; " + log +
            " has what they said"};
  return {};
}

std::vector<std::string> run_by_slurm(EngineWork& work, const EngineOptions& options,
                                      const Console& console) {
  constexpr std::uint64_t most_jobs = 1000;  // Slurm's MaxArraySize is 1001 unless it is set
  std::string trouble;
  const Jobs jobs = jobs_of(work, options, most_jobs, trouble);
  if (!trouble.empty()) return {trouble};
  forget_those_made(work);
  if (work.missing.empty() || Interruption::asked_for()) return {};
  std::string command;
  for (const std::string& word : job_command(work, options)) command += shell_word(word) + " ";
  const std::string script = jobs.list + ".sh";
  const std::string text = "#!/bin/sh\n# A job of an array: the range of its line.\nexec " + command +
                           "--cells \"$(sed -n \"${SLURM_ARRAY_TASK_ID}p\" " + shell_word(jobs.list) +
                           ")\"\n";
  if (const auto wrong = write_files({{script, text}})) return {*wrong};
  const Spoken sent = run_and_read(
      "sbatch", {"--parsable", "--requeue", "--job-name=pal-sweep", "--array=1-" + std::to_string(jobs.count),
                 "--output=" + jobs.list + ".%a.out", script});
  if (sent.status != 0)
    return {sent.status < 0 || sent.status == 127
                ? "sbatch did not run: is Slurm installed here (Debian: apt-get install slurm-client)?"
                : "sbatch refused the jobs; what it said stands above"};
  const std::string job = sent.out.substr(0, sent.out.find_first_of(";\n"));
  Watch watch(work, options, console);
  for (;;) {
    using namespace std::chrono_literals;
    if (!watch.look()) {
      run_and_read("scancel", {job});
      return watch.given_up() ? std::vector<std::string>{no_proof_for(options)} : std::vector<std::string>{};
    }
    const Spoken queue = run_and_read("squeue", {"--noheader", "--jobs=" + job, "--format=%T"});
    // A job that is gone from the queue for some minutes is unknown to it, which is an error.
    if (queue.out.empty()) break;
    std::this_thread::sleep_for(1s);
  }
  forget_those_made(work);
  return {};
}

}  // namespace pal::program
