#include "analyzer/exact/cap.hpp"

#include <algorithm>

namespace pal::analyzer {

Nanoseconds cap_of(const Problem& problem, Nanoseconds limit) {
  Nanoseconds sum = limit;
  for (const Device& device : problem.devices) {
    if (const auto* event = std::get_if<pan::EventDevice>(&device.behaviour)) {
      sum += event->period.count() + event->jitter.count();
    } else if (const auto* request = std::get_if<pan::RequestDevice>(&device.behaviour)) {
      sum += request->answer.worst.count();
    } else if (const auto* frames = std::get_if<pan::FrameDevice>(&device.behaviour)) {
      sum += frames->period.count() + frames->collecting.count();
    }
  }
  const Nanoseconds latency = std::max(problem.within_processor.worst, problem.between_processors.worst);
  for (const Step& step : problem.steps) {
    const Nanoseconds way = step.kind == Step::Kind::send ? latency : 0;
    sum = std::min(sum + step.cost.worst + step.within.value_or(0) + way, most_cap);
  }
  return std::min(4 * sum, most_cap);
}

}  // namespace pal::analyzer
