// What the environment promises of devices, and what is required, as tables.
#include <algorithm>

#include "codegen/emit.hpp"
#include "codegen/names.hpp"

namespace pal::codegen {
namespace {

/// "runtime::DeviceTimes{…}" without its type: what the environment says of the device.
std::string times_of(const Plan& plan, const std::string& device) {
  const auto found = std::find_if(plan.environment.devices.begin(), plan.environment.devices.end(),
                                  [&device](const pan::DeviceTiming& row) { return row.device == device; });
  if (found == plan.environment.devices.end()) return "{}";
  const std::string behaviour = "runtime::DeviceTimes::Behaviour::";
  if (const auto* event = std::get_if<pan::EventDevice>(&found->behaviour)) {
    std::string text = "{" + behaviour + (event->sporadic ? "sporadic" : "events") + ", " +
                       literal(event->message) + ", " + duration(event->period) + ", " +
                       duration(event->jitter);
    if (event->phase) text += ", " + duration(*event->phase);
    return text + "}";
  }
  if (const auto* request = std::get_if<pan::RequestDevice>(&found->behaviour))
    return "{.behaviour = " + behaviour + "on_request, .answer = " + interval(request->answer) +
           (request->may_fail ? ", .may_fail = true}" : "}");
  const auto& frames = std::get<pan::FrameDevice>(found->behaviour);
  return "{.behaviour = " + behaviour + "frames, .period = " + duration(frames.period) +
         ", .answer = " + interval({frames.collecting, frames.collecting}) + "}";
}

/// A table of indices, if it has any, with the name `name`; returns how to refer to it.
std::string indices(Writer& out, const std::string& name, const std::vector<std::size_t>& list) {
  if (list.empty()) return "{}";
  std::vector<std::string> rows;
  for (const std::size_t index : list) rows.push_back(std::to_string(index));
  out.list("constexpr std::array<int, " + std::to_string(list.size()) + "> " + name + "{", rows, "};");
  return name;
}

const char* name_of(PlannedRequirement::Measure measure) {
  using Measure = PlannedRequirement::Measure;
  switch (measure) {
    case Measure::response:
      return "response";
    case Measure::age:
      return "age";
    case Measure::sample:
      return "sample";
    case Measure::interval:
      return "interval";
    case Measure::duration:
      return "duration";
    case Measure::reaction:
      return "reaction";
    case Measure::sample_reaction:
      return "sample_reaction";
    case Measure::loss:
      return "loss";
    case Measure::load:
      return "load";
    case Measure::busy:
      break;
  }
  return "busy";
}

}  // namespace

void write_promises(Writer& out, const Plan& plan) {
  out.line("// What the environment says of each device.");
  out.open("constexpr std::array<runtime::DeviceTimes, " + std::to_string(plan.devices.size()) + "> times{{");
  for (const std::string& device : plan.devices) out.line(times_of(plan, device) + ",");
  out.close("}};").line();

  out.line("// Requirements: their channels and statements, and the threads and devices that they rely on.");
  std::vector<std::string> rows;
  for (std::size_t r = 0; r < plan.requirements.size(); ++r) {
    const PlannedRequirement& requirement = plan.requirements[r];
    const std::string name = "requirement_" + std::to_string(r + 1) + "_";
    std::string row = "{" + literal(requirement.name) +
                      ", runtime::RequirementSpec::Measure::" + name_of(requirement.measure);
    row += ", " + duration(requirement.least) + ", " +
           (requirement.most ? duration(*requirement.most) : "runtime::Time::max()");
    row += ", " + indices(out, name + "channels", requirement.channels);
    row += ", " + indices(out, name + "at", requirement.at);
    row += ", " + (requirement.condition ? std::to_string(*requirement.condition) : std::string("-1"));
    row += ", " + std::to_string(requirement.code);
    row += ", " + indices(out, name + "threads", requirement.threads);
    row += ", " + indices(out, name + "devices", requirement.devices);
    const bool phase = !requirement.after.empty() || !requirement.during.empty();
    if (requirement.device || !requirement.processors.empty() || phase) {
      row += ", " + (requirement.device ? std::to_string(*requirement.device) : std::string("-1"));
      row += ", " + std::to_string(requirement.in);
      row += ", " + indices(out, name + "processors", requirement.processors);
    }
    if (phase) {
      row += ", " + indices(out, name + "after", requirement.after);
      row += ", " + indices(out, name + "during", requirement.during);
    }
    rows.push_back(row + "},");
  }
  out.open("constexpr std::array<runtime::RequirementSpec, " + std::to_string(rows.size()) +
           "> requirements{{");
  for (const std::string& row : rows) out.line(row);
  out.close("}};").line();
  if (plan.kept.empty()) return;
  out.line("// What modules keep of messages: where it comes from, and where it goes.");
  out.open("constexpr std::array<runtime::KeptSpec, " + std::to_string(plan.kept.size()) + "> kept{{");
  for (const PlannedKept& each : plan.kept) {
    const char* how = each.how == PlannedKept::How::taken  ? "taken"
                      : each.how == PlannedKept::How::used ? "used"
                                                           : "written";
    out.line("{runtime::KeptSpec::How::" + std::string(how) + ", " + std::to_string(each.place) + ", " +
             std::to_string(each.kept) + "},");
  }
  out.close("}};").line();
}

}  // namespace pal::codegen
