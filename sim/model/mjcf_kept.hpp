// The part of a scene in MJCF that is not the scene's to say: the machine and its physics. Private to
// pal_sim.
#pragma once

#include <tinyxml2.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pal::sim {

/// Refuses whatever would make another machine of the arm. Everything that is measured or proved of a run
/// rests on the machine as it is.
class MjcfKeeper {
 public:
  /// Takes note of an element of the robot's own file.
  void own(const tinyxml2::XMLElement& element);
  /// Looks at an element of the scene. Throws SceneError in these cases:
  /// - it changes the physics, or how angles and files are read;
  /// - it changes the machine's classes, or the class of all that names none;
  /// - its name is one that only parts of a tool have.
  void look(const tinyxml2::XMLElement& element, const std::string& place);
  /// To be called when all files are read, because a scene may include the robot last. Throws SceneError if
  /// an actuator, an equality, a tendon or a contact of the scene names a part of the robot.
  void finish() const;

 private:
  using Part = std::pair<std::string, std::string>;  // kind ("body", "joint", …) and name
  struct Use {
    Part part;
    std::string element;
    std::string place;
  };

  std::set<Part> own_;
  std::vector<Use> uses_;  // of parts, by sections that change what they name
};

}  // namespace pal::sim
