// Observers of a session: video and progress.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "programs/workcell/session/progress.hpp"
#include "programs/workcell/session/session.hpp"
#include "programs/workcell/session/watched_world.hpp"
#include "sim/report/video.hpp"

namespace pal::workcell {

/// Lives as long as the run.
class RunObservers {
 public:
  /// Throws sim::VideoError when a video that is asked for cannot be made.
  RunObservers(sim::Workcell& workcell, const runtime::Skill& skill, const Session& session);
  RunObservers(const RunObservers&) = delete;
  RunObservers& operator=(const RunObservers&) = delete;

  std::vector<Watcher> watchers();
  /// The run is over: the last line of progress, and the video is whole. What went wrong with it, or nothing.
  std::string end();

 private:
  std::optional<sim::Video> video_;
  bool filmed_ = false;
  std::optional<Progress> progress_;
};

/// Options of a picture with the session's title and threshold.
sim::PictureOptions captioned(sim::PictureOptions options, const runtime::Skill& skill,
                              const Session& session);

}  // namespace pal::workcell
