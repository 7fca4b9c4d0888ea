#include "programs/workcell/reports/report_files.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "programs/workcell/reports/force_options.hpp"
#include "programs/workcell/reports/range_profiles.hpp"
#include "programs/workcell/reports/statistics.hpp"
#include "sim/report/log_table.hpp"

namespace pal::workcell {
namespace {

using Json = nlohmann::ordered_json;

std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string in_folder(const std::string& folder, const char* name) {
  return folder + "/" + name;
}

const char* name(runtime::CostPolicy policy) {
  if (policy == runtime::CostPolicy::worst) return "worst";
  return policy == runtime::CostPolicy::best ? "best" : "random";
}

/// Of the figures that are called _ns: of a loss they are numbers, of a load nanoseconds of work in a second.
const char* unit_name(runtime::BrokenPromise::Unit unit) {
  using Unit = runtime::BrokenPromise::Unit;
  return unit == Unit::messages ? "messages" : unit == Unit::share ? "ns/s" : "ns";
}

Json promises_json(const std::vector<Promise>& promises) {
  Json rows = Json::array();
  for (const Promise& promise : promises)
    rows.push_back({{"name", promise.requirement},
                    {"measure", promise.measure},
                    {"unit", unit_name(promise.unit)},
                    {"bound_ns", promise.proved ? Json(promise.proved->count()) : Json()},
                    {"exact", promise.exact},
                    {"measured_ns", promise.measured ? Json(promise.measured->count()) : Json()}});
  return rows;
}

Json broken_json(const std::vector<runtime::BrokenPromise>& promises) {
  Json rows = Json::array();
  for (const runtime::BrokenPromise& broken : promises) {
    const bool answered = broken.measured != runtime::Time::max();
    rows.push_back({{"promise", broken.promise},
                    {"by", broken.by},
                    {"unit", unit_name(broken.unit)},
                    {"measured_ns", answered ? Json(broken.measured.count()) : Json()},
                    {"first_ns", broken.first.count()},
                    {"times", broken.times},
                    {"endangers", broken.endangers}});
  }
  return rows;
}

Json run_json(const runtime::Skill& skill, const Session& session, const SessionResult& result,
              const std::vector<Promise>& promises) {
  Json parameters = Json::object();
  for (const runtime::ParameterSpec& parameter : skill.description().parameters) {
    const bool text = parameter.type == runtime::ParameterType::text;
    parameters[std::string(parameter.name)] = {
        {"value", text ? Json(text_parameter(parameter, session))
                       : Json(*parameter_value(skill, session, parameter.name))},
        {"unit", parameter.unit}};
  }
  Json json;
  json["skill"] = skill.description().name;
  json["environment"] = skill.description().environment;
  json["scene"] = session.scene.name;
  if (session.before) json["after"] = session.before->name;
  json["parameters"] = parameters;
  json["seed"] = session.seed;
  json["times"] = name(session.times);
  json["alter_phase_ns"] = result.phase.count();
  json["completion"] = {{"code", result.outcome.code},
                        {"fault", result.outcome.fault},
                        {"reason", result.outcome.reason},
                        {"controller", result.controller},
                        {"time_ns", result.outcome.duration.count()}};
  json["overruns"] = result.outcome.overruns;
  json["broken_promises"] = broken_json(result.outcome.broken_promises);
  json["peak_force_N"] = result.peak_force;
  json["resting_force_N"] = result.resting_force;
  json["requirements"] = promises_json(promises);
  return json;
}

std::string nanoseconds(const std::optional<runtime::Time>& time) {
  return time ? std::to_string(time->count()) : "";
}

Json figures_json(const std::vector<double>& values) {
  const Distribution figures = distribution(values);
  return {{"count", figures.count},
          {"least", figures.least},
          {"median", figures.median},
          {"mean", figures.mean},
          {"greatest", figures.greatest}};
}

}  // namespace

std::vector<OutputFile> run_files(const std::string& folder, const runtime::Skill& skill,
                                  const Session& session, const SessionResult& result,
                                  const std::vector<Promise>& promises) {
  const trace::Trace& trace = result.outcome.trace;
  const auto write_trace = [&](std::ostream& out) {
    trace::write_json(trace, result.events ? trace::events_of(*result.events) : trace::events_of(trace), out);
  };
  const auto write_chrome = [&](std::ostream& out) { trace::write_chrome(trace, out); };
  const auto write_log = [&](std::ostream& out) {
    sim::write_log_table([&](const auto& see) { result.samples->for_each(see); }, result.messages, out);
  };
  std::vector<OutputFile> files{
      {in_folder(folder, "trace.json"), {}, write_trace},
      {in_folder(folder, "trace.chrome.json"), {}, write_chrome},
      {in_folder(folder, "log.csv"), {}, write_log},
      {in_folder(folder, "run.json"), json_text(run_json(skill, session, result, promises))}};
  for (const Promise& promise : promises)
    if (!promise.chart.empty())
      files.push_back({folder + "/atc." + promise.requirement + ".svg", promise.chart});
  if (result.picture.image)
    files.push_back({in_folder(folder, "arm.png"), sim::encode_png(*result.picture.image)});
  return files;
}

sim::DrawnPlots run_plots(const runtime::Skill& skill, const Session& session, const SessionResult& result) {
  const std::string heading = title(skill, session);
  const sim::ForcePlotOptions force = force_options(skill, session, heading, result.outcome.duration);
  std::vector<sim::Plot> plots = range_plots(result.messages, heading);
  if (sim::shows_force(result.log, result.messages, force))
    plots.push_back(sim::force_plot(result.log, result.messages, force));
  plots.push_back(sim::position_plot(result.log, heading, result.outcome.duration));
  plots.push_back(sim::path_plot(result.log, heading));
  return sim::draw(plots);
}

std::vector<OutputFile> sweep_files(const std::string& folder, const std::vector<std::string>& skills,
                                    const std::vector<std::vector<SweepRun>>& sweeps,
                                    const std::optional<Comparison>& comparison) {
  std::string csv =
      "skill,alter_phase_ns,raise_mm,seed,completion,fault,peak_force_N,resting_force_N,overshoot_N,age_ns,"
      "greatest_age_ns\n";
  Json json = Json::object();
  for (std::size_t k = 0; k < sweeps.size(); ++k) {
    std::vector<double> overshoots;
    for (const SweepRun& run : sweeps[k]) {
      csv +=
          fmt::format("{},{},{:.6f},{},{},{},{:.6f},{:.6f},{:.6f},{},{}\n", skills[k], run.phase.count(),
                      run.raise, run.seed, run.completion, run.fault ? 1 : 0, run.peak_force,
                      run.resting_force, run.overshoot, nanoseconds(run.age), nanoseconds(run.greatest_age));
      if (!run.fault && run.completion == 0) overshoots.push_back(run.overshoot);
    }
    json["overshoot_N"][skills[k]] = figures_json(overshoots);
  }
  if (comparison)
    json["comparison"] = {{"pairs", comparison->pairs},
                          {"speed_mm_per_s", comparison->speed},
                          {"stiffness_N_per_mm", comparison->stiffness},
                          {"age_difference_ms", comparison->age_difference},
                          {"predicted_N", comparison->predicted},
                          {"resting_difference_N", comparison->resting_difference},
                          {"peak_difference_N", comparison->peak_difference},
                          {"agrees", comparison->agrees()}};
  return {{in_folder(folder, "sweep.csv"), csv}, {in_folder(folder, "sweep.json"), json_text(json)}};
}

}  // namespace pal::workcell
