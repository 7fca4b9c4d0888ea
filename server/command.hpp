// What a client may ask for. Both protocols make these, so that both mean the same.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "operations/executor.hpp"
#include "pal/support/time.hpp"
#include "server/pendant.hpp"

namespace pal::server {

using ClientId = std::uint64_t;
struct Location;

/// With `force` a programmer takes them from another client, while nothing runs.
struct TakeControls {
  std::string reason{};
  bool force = false;
};
/// Tells the client that has them.
struct AskForControls {
  std::string reason;
};
struct GiveControls {
  ClientId to = 0;
};
/// What runs goes on.
struct ReleaseControls {};
/// What runs pauses after its step; nothing begins to move, of any client, until the hold is released.
struct SetHold {
  std::string reason;
};
struct ReleaseHold {};
struct RunSkill {
  std::string skill;
  std::vector<operations::Parameter> parameters;
  bool goes_on = false;  // when its client goes; else it is stopped then
};
/// Where the files of an operation came from.
struct StoredVersion {
  std::string name;
  std::uint64_t version = 0;
};
/// The files by their names; `main` is the one to run.
struct LoadOperation {
  std::map<std::string, std::string> files;
  std::string main;
  std::optional<StoredVersion> stored{};
};
/// run: from where the token is, after the end from START. resume: only what is paused or stopped.
struct RunOperation {
  enum class How { run, step, resume };
  How how = How::run;
};
/// After the current skill.
struct Pause {};
/// At once: the current skill is cut off. A pause is over, too.
struct Stop {};
struct PutToken {
  std::string icon;
};
struct SetParameter {
  std::string icon, parameter;
  operations::Value value;
};
/// With a number it changes that one, else it adds one.
struct SetBreakpoint {
  operations::Breakpoint breakpoint;
};
struct RemoveBreakpoint {
  std::size_t number = 0;
};
struct ClearBreakpoints {};
/// Where the robot is, under this name. `based_on`: the version that the client knows; 0: it must be new.
struct TeachLocation {
  std::string location;
  std::optional<std::uint64_t> based_on{};
  std::optional<std::array<double, 6>> pose{};  // as of Location; nothing: where the robot is
};
struct RenameLocation {
  std::string location, to;
  std::optional<std::uint64_t> based_on{};
};
struct DeleteLocation {
  std::string location;
  std::optional<std::uint64_t> based_on{};
};
/// The place of the tool and of the joints, while nothing moves.
struct WhereIsRobot {};
/// While nothing runs.
struct ReadSensor {
  std::string sensor;
};
/// The place of the answer, from 0, or its text.
struct AnswerQuestion {
  std::string icon;
  std::variant<std::size_t, std::string> answer;
};

/// The arm moves while orders come; answered when it is at rest. The parameters are those of the skill `jog`.
struct StartJog {
  std::vector<operations::Parameter> parameters;
};
/// Of the client that jogs: its person is there, and wants this.
struct KeepJog {
  JogAxes axes{};
};
/// Its person has let go.
struct EndJog {};

using Command =
    std::variant<TakeControls, AskForControls, GiveControls, ReleaseControls, SetHold, ReleaseHold, RunSkill,
                 LoadOperation, RunOperation, Pause, Stop, PutToken, SetParameter, SetBreakpoint,
                 RemoveBreakpoint, ClearBreakpoints, AnswerQuestion, TeachLocation, RenameLocation,
                 DeleteLocation, WhereIsRobot, ReadSensor, StartJog, KeepJog, EndJog>;

/// How a command ended that was obeyed.
struct Done {
  operations::SkillResult result{};  // of RunSkill: what came of the skill
  Duration begin{}, end{};
  std::string operation{};                             // of LoadOperation: its name
  std::optional<operations::Value> before{};           // of SetParameter; nothing: it was not set
  std::optional<operations::Breakpoint> breakpoint{};  // of SetBreakpoint
  std::shared_ptr<const Location> location{};          // of TeachLocation and RenameLocation
  std::optional<double> reading{};                     // of ReadSensor, at `end`
};

/// Where in the texts of an operation something is wrong; what is not known is empty.
struct TextPlace {
  std::string file, operation, icon, field;
  int line = 0, column = 0;  // from 1; 0: not known
};

/// Why it was not obeyed. Nothing has moved then.
struct Refusal {
  enum class Why {
    not_yours,  // another client has the controls
    busy,       // a skill or an operation runs
    nothing,    // there is nothing to run, pause, resume or answer
    wrong,      // the skill, parameter, icon, operation or name is wrong
    ending,     // the server ends
    role,       // this client's role may not do that
    held,       // a hold is set
    newer,      // somebody has saved or taught a newer version
    absent,     // there is no such thing
    exists,     // the name is taken
    cancelled,  // the client cancelled it
    too_much,   // a limit of size or number
    failed      // the disk or a device failed
  };
  Why why = Why::wrong;
  std::string message;
  std::string hint{};  // a way out; may be empty
  TextPlace place{};
  std::optional<std::uint64_t> newest{};              // of `newer`
  std::optional<std::pair<double, double>> limits{};  // of `role`: what an operator may set

  /// For a client that has one line.
  std::string text() const {
    const std::string at =
        place.file.empty() || place.line == 0
            ? ""
            : place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": ";
    return at + (hint.empty() ? message : message + "; " + hint);
  }
};

using Reply = std::variant<Done, Refusal>;
/// Called once, by any thread; must not call the desk.
using Answerer = std::function<void(const Reply&)>;

}  // namespace pal::server
