// What clients of a server may know of the skills: their templates, and what is proved of them.
#pragma once

#include <atomic>
#include <thread>
#include <vector>

#include "programs/workcell/session/skill_pictures.hpp"
#include "programs/workcell/session/skills.hpp"
#include "server/knowledge.hpp"

namespace pal::workcell {

/// Reads the PAL of the skills in a thread of its own, draws them and proves them there, one after the other;
/// the knowledge grows meanwhile. A skill without PAL stays as the program knows it.
class SkillScholar {
 public:
  /// All outlive the scholar.
  SkillScholar(const std::vector<KnownSkill>& known, server::Knowledge& knowledge,
               const SkillPictures& pictures);
  /// Leaves what it has not proved yet.
  ~SkillScholar();
  SkillScholar(const SkillScholar&) = delete;
  SkillScholar& operator=(const SkillScholar&) = delete;

 private:
  void study(const std::vector<KnownSkill>& known, server::Knowledge& knowledge,
             const SkillPictures& pictures) const;

  std::atomic<bool> ending_ = false;
  std::thread thread_;
};

}  // namespace pal::workcell
