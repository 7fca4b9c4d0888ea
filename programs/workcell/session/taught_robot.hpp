// The cell's robot as one that can be taught locations.
#pragma once

#include <map>
#include <string>

#include "server/locations.hpp"
#include "sim/cell/cell.hpp"

namespace pal::workcell {

class CellRobot final : public server::TaughtRobot {
 public:
  /// The cell outlives it.
  explicit CellRobot(sim::Cell& cell) : cell_(cell) {}

  /// All that it has been taught, as poses.
  std::map<std::string, server::PoseFigures> taught() const;
  /// It has these, and no others.
  void teach_all(const std::vector<server::Location>& locations);

  server::Location here() const override;
  void teach(const std::string& name, const server::PoseFigures& pose) override;
  void forget(const std::string& name) override;
  std::string problem_of_name(const std::string& name) const override;

 private:
  sim::Cell& cell_;
};

}  // namespace pal::workcell
