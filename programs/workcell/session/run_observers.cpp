#include "programs/workcell/session/run_observers.hpp"

namespace pal::workcell {

sim::PictureOptions captioned(sim::PictureOptions options, const runtime::Skill& skill,
                              const Session& session) {
  options.title = title(skill, session);
  options.threshold = parameter_value(skill, session, "threshold");
  // A skill that holds a force has set it.
  if (const auto force = parameter_value(skill, session, "force"); !options.threshold && force) {
    options.threshold = force;
    options.threshold_name = "force that is set";
  }
  return options;
}

RunObservers::RunObservers(sim::Workcell& workcell, const runtime::Skill& skill, const Session& session) {
  if (!session.video.empty()) {
    sim::VideoOptions options{.file = session.video};
    options.picture = captioned(options.picture, skill, session);
    video_.emplace(workcell, options);
  }
  if (session.progress != nullptr) progress_.emplace(workcell, *session.progress, session.terminal);
}

std::vector<Watcher> RunObservers::watchers() {
  std::vector<Watcher> result;
  if (video_)
    result.push_back({sim::video_period, [this] {
                        filmed_ = true;
                        video_->film();
                      }});
  if (progress_) result.push_back({Progress::period, [this] { progress_->show(); }});
  return result;
}

std::string RunObservers::end() {
  if (progress_) progress_->end();
  if (!video_) return {};
  try {
    if (!filmed_) video_->film();  // the skill did not begin
    video_->finish();
    return {};
  } catch (const sim::VideoError& problem) {
    return problem.what();
  }
}

}  // namespace pal::workcell
