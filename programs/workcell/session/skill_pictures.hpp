// Pictures of skills as files, for clients of a server: their modules as graphs, their worst runs as charts.
#pragma once

#include <string>
#include <vector>

#include "pal/pan/network.hpp"
#include "programs/pal/session/proof.hpp"
#include "server/knowledge.hpp"

namespace pal::workcell {

/// Writes pictures into a folder of its own, which goes with it.
class SkillPictures {
 public:
  /// Throws std::runtime_error if there is no place for the folder.
  SkillPictures();
  ~SkillPictures();
  SkillPictures(const SkillPictures&) = delete;
  SkillPictures& operator=(const SkillPictures&) = delete;

  const std::string& folder() const { return folder_; }

  // These add to `pictures` what they have written; a picture that cannot be drawn or written is left out.
  using Pictures = std::vector<server::SkillFacts::Picture>;
  /// One of each module with a body.
  void draw_modules(const pan::Network& network, Pictures& pictures) const;
  /// One of each requirement with a run to show.
  void draw_runs(const program::Proof& proof, Pictures& pictures) const;

 private:
  void add(const std::string& skill, const std::string& name, const std::string& title,
           const std::string& svg, Pictures& pictures) const;

  std::string folder_;
};

}  // namespace pal::workcell
