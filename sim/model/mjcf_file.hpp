// Scenes that are written in MJCF: read, looked through and put together before MuJoCo sees them. Private to
// pal_sim.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/scene.hpp"

namespace pal::sim {

/// A scene's file and all that it includes as one text, an element a line. puma560.xml and cell.xml are the
/// machine's own.
struct MjcfFile {
  std::string text;
  std::vector<std::string> places;            // "FILE:LINE" of each line of `text`
  std::map<std::string, std::string> custom;  // the same of the fields in <custom>, by their names
};

/// Throws SceneError, with file and line, in these cases:
/// - the file is not XML;
/// - an element or an attribute is none of MJCF;
/// - a name is given twice;
/// - the scene changes the physics or the arm.
MjcfFile read_mjcf(const Scene& scene);

/// Why MuJoCo does not take the text, in plain words and with the place in the scene's files.
SceneError refusal_of(const MjcfFile& file, const Scene& scene, const std::string& said);

}  // namespace pal::sim
