// What the desk does with the robot and its sensors between skills: locations are taught, sensors are read.
#include <fmt/format.h>

#include "server/desk_parts.hpp"
#include "server/disk_file.hpp"

namespace pal::server {

Desk::Parts::Result Desk::Parts::begin_service(Asked& asked, std::function<Served()> work) {
  begin(Activity::service);
  service_job = ServiceJob{std::move(work), std::exchange(asked.answer, nullptr)};
  return std::nullopt;
}

void Desk::Parts::work_on(ServiceJob& job) {
  runner.allow();
  {
    const Locked lock(*this);
    if (stops != accepted_stops) runner.stop();
  }
  Served served;
  try {
    served = job.work();
  } catch (const StoreProblem& problem) {
    served.reply = problem.refusal;
  }
  {
    const Locked lock(*this);
    status.activity = Activity::idle;
    status.pausing = status.stopping = false;
    set_time(runner.now());
    if (served.event) {
      cell.locations = options.book->names();
      cell_copy.reset();
      publish(std::move(*served.event));
    }
  }
  job.answer(served.reply);
}

Desk::Parts::Result Desk::Parts::need_locations() const {
  if (options.book != nullptr && options.robot != nullptr) return std::nullopt;
  return Refusal{Refusal::Why::absent, "this cell's locations cannot be changed"};
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, TeachLocation& command) {
  if (auto refusal = need_controls(asked.client)) return refusal;
  if (auto refusal = need_rest()) return refusal;
  if (auto refusal = need_locations()) return refusal;
  if (const std::string problem = options.robot->problem_of_name(command.location); !problem.empty())
    return Refusal{Refusal::Why::wrong, problem, "choose another name"};
  give_controls(asked.client);
  return begin_service(asked, [this, command, by = name_of(asked.client)]() -> Served {
    Location place;
    if (command.pose) {
      place.pose = *command.pose;
    } else {
      place = options.robot->here();
    }
    const Location taught = options.book->teach(command.location, place, command.based_on, by);
    options.robot->teach(taught.name, taught.pose);
    Done done;
    done.location = std::make_shared<Location>(taught);
    return {done, LocationChanged{taught.name, LocationChanged::Change::taught, taught.version, {}, by}};
  });
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, RenameLocation& command) {
  if (auto refusal = need_controls(asked.client)) return refusal;
  if (auto refusal = need_rest()) return refusal;
  if (auto refusal = need_locations()) return refusal;
  if (const std::string problem = options.robot->problem_of_name(command.to); !problem.empty())
    return Refusal{Refusal::Why::wrong, problem, "choose another name"};
  give_controls(asked.client);
  return begin_service(asked, [this, command, by = name_of(asked.client)]() -> Served {
    const Location moved = options.book->rename(command.location, command.to, command.based_on, by);
    options.robot->teach(moved.name, moved.pose);
    options.robot->forget(command.location);
    Done done;
    done.location = std::make_shared<Location>(moved);
    return {done, LocationChanged{command.location, LocationChanged::Change::renamed, moved.version,
                                  moved.name, by}};
  });
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, DeleteLocation& command) {
  if (auto refusal = need_controls(asked.client)) return refusal;
  if (auto refusal = need_rest()) return refusal;
  if (auto refusal = need_locations()) return refusal;
  give_controls(asked.client);
  return begin_service(asked, [this, command, by = name_of(asked.client)]() -> Served {
    const std::uint64_t version = options.book->remove(command.location, command.based_on);
    options.robot->forget(command.location);
    return {Done{}, LocationChanged{command.location, LocationChanged::Change::deleted, version, {}, by}};
  });
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, WhereIsRobot&) {
  if (ending) return Refusal{Refusal::Why::ending, "the server ends"};
  if (auto refusal = need_rest()) return refusal;
  if (options.robot == nullptr) return Refusal{Refusal::Why::absent, "this cell tells no places"};
  return begin_service(asked, [this]() -> Served {
    Done done;
    done.location = std::make_shared<Location>(options.robot->here());
    return {done};
  });
}

Desk::Parts::Result Desk::Parts::obey(Asked& asked, ReadSensor& command) {
  if (ending) return Refusal{Refusal::Why::ending, "the server ends"};
  if (auto refusal = need_rest()) return refusal;
  if (!options.sensors.contains(command.sensor))
    return Refusal{Refusal::Why::absent, fmt::format("the cell has no sensor '{}'", command.sensor),
                   "'sensors' lists those that it has"};
  return begin_service(asked, [this, command]() -> Served {
    Done done;
    done.begin = runner.now();
    const operations::Reading reading = asking_runner.sense(command.sensor);
    done.end = runner.now();
    done.reading = reading.value;
    if (reading.value) return {done};
    return {Refusal{Refusal::Why::failed, reading.stopped ? "the reading was stopped" : reading.problem}};
  });
}

}  // namespace pal::server
