#include "operations/step_log.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <ostream>

namespace pal::operations {
namespace {

using Json = nlohmann::ordered_json;

double seconds(Duration time) {
  return static_cast<double>(time.count()) / 1e9;
}

}  // namespace

std::string log_line(const Step& step) {
  Json line;
  line["step"] = step.number;
  line["icon"] = step.icon;
  if (!step.skill.empty()) {
    line["skill"] = step.skill;
    line["parameters"] = Json::object();
    for (const Parameter& parameter : step.parameters)
      std::visit([&](const auto& value) { line["parameters"][parameter.name] = value; }, parameter.value);
    static constexpr std::array kinds{"normal", "contingency", "error", "stopped"};
    line["kind"] = kinds[static_cast<std::size_t>(step.result.kind)];
    line["code"] = step.result.code;
    line["reason"] = step.result.reason;
  }
  line["begin_s"] = seconds(step.begin);
  line["end_s"] = seconds(step.end);
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void StepLog::done(const Step& step) {
  out_ << log_line(step) << '\n' << std::flush;
}

}  // namespace pal::operations
