// Places that the robot has been taught, by name, with versions. They are kept with the cell.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "server/event.hpp"

namespace pal::server {

/// x, y, z in mm, then O, A, T in degrees.
using PoseFigures = std::array<double, 6>;

struct Location {
  std::string name;
  PoseFigures pose{};
  std::optional<std::array<double, 6>> joints{};  // degrees, when it was taught
  std::uint64_t version = 1;                      // counts each change of this name
  std::optional<WallTime> changed{};              // nothing: as the cell was made
  std::string by{};
};

/// The robot's side. Called by the cell's thread only, while nothing moves.
class TaughtRobot {
 public:
  virtual ~TaughtRobot() = default;
  /// Where the tool's tip and the joints are.
  virtual Location here() const = 0;
  virtual void teach(const std::string& name, const PoseFigures& pose) = 0;
  virtual void forget(const std::string& name) = 0;
  /// Why the robot cannot use the name; empty: it can. From any thread.
  virtual std::string problem_of_name(const std::string& name) const = 0;
};

/// For all threads. Functions throw StoreProblem.
class Locations {
 public:
  static constexpr std::size_t most = 10'000;

  /// `made`: those that the cell has without being taught. What was changed is kept in `folder`, which is
  /// made if it is not there; empty: until the program ends. Throws StoreProblem.
  Locations(const std::map<std::string, PoseFigures>& made, std::string folder);

  std::vector<Location> list() const;
  std::set<std::string> names() const;
  /// `based_on`: the version that was changed; 0: the name must be new; nothing: whatever there is.
  Location teach(const std::string& name, const Location& here, std::optional<std::uint64_t> based_on,
                 const std::string& by);
  Location rename(const std::string& name, const std::string& to, std::optional<std::uint64_t> based_on,
                  const std::string& by);
  /// The version that was deleted.
  std::uint64_t remove(const std::string& name, std::optional<std::uint64_t> based_on);

 private:
  void read();
  void check(const std::string& name, std::optional<std::uint64_t> based_on) const;
  /// The changed locations are on the disk, or nothing has changed.
  void keep(std::map<std::string, Location> changed, std::map<std::string, std::uint64_t> deleted);

  mutable std::mutex mutex_;
  std::string folder_;
  std::map<std::string, Location> locations_;
  std::map<std::string, std::uint64_t> deleted_;  // their last versions
};

}  // namespace pal::server
