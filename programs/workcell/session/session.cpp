#include "programs/workcell/session/session.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "programs/workcell/session/run_observers.hpp"
#include "sim/cell/cell.hpp"
#include "sim/cell/sensors.hpp"
#include "sim/picture/peak_history.hpp"

namespace pal::workcell {
namespace {

constexpr runtime::Time rest = std::chrono::milliseconds(400);
constexpr runtime::Time rest_after_fault = std::chrono::milliseconds(800);  // the arm backs off first
// Events of a run in real time, 16 MB: a trace that had to grow would hold the kernel for milliseconds.
constexpr std::size_t real_time_trace = 1U << 19U;

// What stays in memory of a run: more of it is on the disk alone.
constexpr std::size_t most_samples = 60'000;  // 17 MB
constexpr std::size_t most_events = 300'000;  // 10 MB
constexpr std::size_t events_at_a_time = 1U << 12U;

/// The threads of a run in real time wait for no disk.
trace::SpoolPlace spool_of(const Session& session) {
  return session.real_time ? trace::SpoolPlace::memory : trace::SpoolPlace::disk;
}

/// The samples of a run as they come: all in a spool, and what pictures show of them.
class SampleRecorder {
 public:
  SampleRecorder(sim::Workcell& workcell, trace::SpoolPlace place)
      : spool_(std::make_shared<sim::SampleSpool>(place)),
        listener_(workcell.on_sample([this, tool = workcell.tool_kind()](const sim::Sample& sample) {
          spool_->append(sample);
          history_.add({std::chrono::duration<double>(sample.time).count(),
                        tool == sim::ToolKind::gripper ? sample.grip_force : sample.contact_force});
        })) {}
  SampleRecorder(const SampleRecorder&) = delete;
  SampleRecorder& operator=(const SampleRecorder&) = delete;

  const std::shared_ptr<sim::SampleSpool>& spool() const { return spool_; }
  const sim::PeakHistory& history() const { return history_; }

 private:
  std::shared_ptr<sim::SampleSpool> spool_;
  sim::PeakHistory history_;
  std::shared_ptr<void> listener_;
};

/// The distances that the range finder measured.
sim::PeakHistory distances(const sim::MessageLog& messages) {
  sim::PeakHistory history;
  messages.for_each([&](const sim::LoggedMessage& message) {
    const auto& device = messages.devices()[message.device];
    if (device.name != "range-finder" || device.ports[message.port].message != "profile") return;
    if (const auto nearest = sim::quantity("range-nearest", message.fields))
      history.add({std::chrono::duration<double>(message.time).count(), *nearest});
  });
  return history;
}

/// Gives the trace its events: all of them, or of a long run the last ones.
void take_events(SessionResult& result, std::shared_ptr<trace::EventSpool> spool) {
  const std::size_t count = spool->size();
  trace::Events& events = result.outcome.trace.events;
  events.reserve(std::min(count, most_events));
  spool->for_each([&events](const trace::Event& event) { events.push_back(event); },
                  count - std::min(count, most_events));
  if (count > most_events) result.events = std::move(spool);
}

void take_samples(SessionResult& result, const SampleRecorder& recorder) {
  result.samples = recorder.spool();
  result.log = result.samples->telling(most_samples);
  for (const sim::Sample& sample : result.log)
    result.peak_force = std::max(result.peak_force, sample.contact_force);
  if (!result.log.empty()) result.resting_force = result.log.back().contact_force;
}

void run_before(sim::Cell& cell, const Session& session) {
  if (!session.before) return;
  const auto skill = session.before->make();
  runtime::RunOptions options;
  options.costs = session.times;
  options.seed = session.seed;
  options.control = session.control;
  options.trace = runtime::TraceMode::none;
  const runtime::Outcome outcome = cell.run(*skill, {}, options);
  if (outcome.code != 0)
    throw sim::SceneError(
        std::string(skill->description().name) + " in scene " + session.scene.name,
        "the skill before ended with completion " + std::to_string(outcome.code) + ": " + outcome.reason,
        "choose a scene in which it ends with completion 0");
}

/// The workcell, and what looks at it, which goes before it.
struct ObservedWorld final : runtime::World {
  ObservedWorld(sim::Workcell& cell, const runtime::Skill& skill, const Session& session)
      : workcell(cell), observers(cell, skill, session), watched(cell, observers.watchers()) {}
  void advance_to(runtime::Time when) override { watched.advance_to(when); }

  sim::Workcell& workcell;
  RunObservers observers;
  WatchedWorld watched;
};

/// The observers of messages: the log, and the measurement, if there is one.
class MessageObservers final : public runtime::MessageObserver {
 public:
  MessageObservers(sim::MessageLog& log, runtime::Measurement* measurement)
      : log_(log), measurement_(measurement) {}
  void passed(runtime::Time when, const runtime::Device& device, std::size_t port,
              std::span<const double> fields) override {
    log_.passed(when, device, port, fields);
    if (measurement_ != nullptr) measurement_->passed(when, device, port, fields);
  }
  void forgotten(const runtime::Device& device, std::size_t port) override {
    if (measurement_ != nullptr) measurement_->forgotten(device, port);
  }

 private:
  sim::MessageLog& log_;
  runtime::Measurement* measurement_;
};

}  // namespace

std::string title(const runtime::Skill& skill, const Session& session) {
  return std::string(skill.description().name) + " in scene " + session.scene.name;
}

SessionResult run_session(runtime::Skill& skill, const Session& session) {
  SessionResult result;
  result.messages = sim::MessageLog(spool_of(session));
  ObservedWorld* world = nullptr;
  sim::CellOptions cell_options;
  cell_options.raise = session.raise;
  cell_options.seed = session.seed;
  cell_options.machine_seed = session.machine_seed;
  cell_options.times = session.times;
  cell_options.phase = session.phase;
  cell_options.pace = session.pace;
  cell_options.carrier = session.carrier;
  cell_options.faults = session.faults;
  cell_options.watch = [&](sim::Workcell& workcell) {
    auto made = std::make_unique<ObservedWorld>(workcell, skill, session);
    world = made.get();
    return made;
  };
  cell_options.keep_log = false;
  std::optional<SampleRecorder> samples;
  bool before = true;
  cell_options.at_begin = [&](runtime::Time begin) {
    if (before) return;
    world->workcell.begin_log(begin);
    samples.emplace(world->workcell, spool_of(session));
    world->watched.begin(begin);
  };
  sim::Cell cell(session.scene, cell_options);
  run_before(cell, session);
  before = false;

  runtime::RunOptions options;
  options.costs = session.times;
  options.seed = session.seed;
  options.control = session.control;
  MessageObservers observers(result.messages, session.measurement);
  options.observer = &observers;
  options.work = session.measurement;
  if (session.measurement != nullptr) session.measurement->begin_run();
  options.on_broken_promise = session.on_broken_promise;
  options.slow = session.slow;
  options.live = session.live;
  options.horizon = session.limit;
  options.real_time = session.real_time;
  if (session.real_time) options.trace_capacity = real_time_trace;
  const auto events = session.real_time ? nullptr : std::make_shared<trace::EventSpool>();
  if (events) {
    options.spool = events.get();
    options.trace_capacity = events_at_a_time;
  }
  result.outcome = cell.run(skill, session.parameters, options);
  result.phase = cell.phase();
  result.controller = cell.val_driver().last_error();
  result.slow = session.slow;
  result.faults_to_come = cell.faults_to_come();

  cell.rest(cell.workcell().fault() ? rest_after_fault : rest);
  // Before the picture: OpenGL is drawn with by one thread at a time.
  result.video_problem = world->observers.end();
  if (events) take_events(result, events);
  if (samples) take_samples(result, *samples);
  if ((events && events->failed()) || (samples && samples->spool()->failed()) || result.messages.failed())
    throw std::runtime_error("the run cannot be written down: the folder for temporary files is full");
  if (session.picture && samples) {
    sim::PictureOptions picture = captioned({}, skill, session);
    const bool sees = cell.workcell().tool_kind() == sim::ToolKind::range_finder;
    picture.history = (sees ? distances(result.messages) : samples->history()).points();
    result.picture = sim::take_picture(cell.workcell(), picture);
  }
  return result;
}

std::optional<double> parameter_value(const runtime::Skill& skill, const Session& session,
                                      std::string_view name) {
  for (const runtime::ParameterValue& parameter : session.parameters)
    if (parameter.name == name) return parameter.value;
  for (const runtime::ParameterSpec& parameter : skill.description().parameters)
    if (parameter.name == name) return parameter.default_value;
  return std::nullopt;
}

std::string text_parameter(const runtime::ParameterSpec& parameter, const Session& session) {
  std::string text(parameter.default_text);
  for (const runtime::ParameterValue& value : session.parameters)
    if (value.name == parameter.name) text = value.text.value_or(text);
  return text;
}

}  // namespace pal::workcell
