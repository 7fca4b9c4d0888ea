#include "sim/report/sample_spool.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

namespace pal::sim {

SampleSource samples_of(const std::vector<Sample>& log) {
  return [&log](const std::function<void(const Sample&)>& see) {
    for (const Sample& sample : log) see(sample);
  };
}

SampleSpool::Row SampleSpool::row_of(const Sample& sample) {
  Row row{sample.time.count(), {}};
  double* to = row.figures;
  const auto put = [&to](const auto& values) { to = std::copy(values.begin(), values.end(), to); };
  put(sample.joints);
  put(sample.joint_set_point);
  put(sample.tool);
  put(sample.tool_turn.coeffs());
  put(sample.set_point);
  put(sample.set_point_turn.coeffs());
  put(sample.wrench.force);
  put(sample.wrench.torque);
  put(std::array{sample.contact_force, sample.grip_force, sample.gripper_width});
  return row;
}

Sample SampleSpool::sample_of(const Row& row) {
  Sample sample;
  sample.time = runtime::Time(row.time_ns);
  const double* from = row.figures;
  const auto take = [&from](auto&& values) {
    std::copy_n(from, values.size(), values.begin());
    from += values.size();
  };
  take(sample.joints);
  take(sample.joint_set_point);
  take(sample.tool);
  take(sample.tool_turn.coeffs());
  take(sample.set_point);
  take(sample.set_point_turn.coeffs());
  take(sample.wrench.force);
  take(sample.wrench.torque);
  sample.contact_force = from[0];
  sample.grip_force = from[1];
  sample.gripper_width = from[2];
  return sample;
}

void SampleSpool::append(const Sample& sample) noexcept {
  rows_.append(row_of(sample));
}

void SampleSpool::for_each(const std::function<void(const Sample&)>& see) const {
  rows_.for_each([&see](const Row& row) { see(sample_of(row)); });
}

std::vector<Sample> SampleSpool::telling(std::size_t most) const {
  std::vector<Sample> kept;
  kept.reserve(std::min(size(), most));
  if (size() <= most) {
    for_each([&kept](const Sample& sample) { kept.push_back(sample); });
    return kept;
  }
  constexpr std::size_t of_a_bin = 6;  // the greatest and the least of three values
  const std::size_t bin = (size() * of_a_bin + most - 1) / most;
  std::vector<Sample> some;
  const auto close = [&] {
    std::set<std::size_t> telling;
    for (const auto value : {+[](const Sample& sample) { return sample.contact_force; },
                             +[](const Sample& sample) { return sample.grip_force; },
                             +[](const Sample& sample) { return (sample.tool - sample.set_point).norm(); }}) {
      const auto [least, greatest] = std::minmax_element(
          some.begin(), some.end(), [&](const Sample& a, const Sample& b) { return value(a) < value(b); });
      telling.insert(static_cast<std::size_t>(std::distance(some.begin(), least)));
      telling.insert(static_cast<std::size_t>(std::distance(some.begin(), greatest)));
    }
    for (const std::size_t index : telling) kept.push_back(some[index]);
    some.clear();
  };
  for_each([&](const Sample& sample) {
    some.push_back(sample);
    if (some.size() == bin) close();
  });
  if (!some.empty()) close();
  return kept;
}

}  // namespace pal::sim
