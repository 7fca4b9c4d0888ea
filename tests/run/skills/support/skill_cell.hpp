// One cell in which several skills run, one after the other.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "runtime/dispatcher.hpp"
#include "sim/cell/cell.hpp"

namespace pal::test {

class SkillCell {
 public:
  explicit SkillCell(const std::string& scene_name, std::uint64_t seed = 1);

  /// A tool that points straight down, mm in frame 0.
  void teach(const std::string& location, double x, double y, double z);
  /// Until the arm has come to rest. Throws if there is no such skill.
  runtime::Outcome run(const std::string& skill, const std::vector<runtime::ParameterValue>& parameters = {});

  sim::Workcell& workcell() { return cell_.workcell(); }
  /// Where the tip is, mm.
  Eigen::Vector3d tip() { return workcell().tool().translation() * 1e3; }

 private:
  sim::Cell cell_;
};

/// A parameter that is a text.
runtime::ParameterValue text(const std::string& name, const std::string& value);

}  // namespace pal::test
