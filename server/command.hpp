// What a client may ask for. Both protocols make these, so that both mean the same.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "operations/executor.hpp"
#include "pal/support/time.hpp"

namespace pal::server {

struct TakeControls {};
/// What runs goes on.
struct ReleaseControls {};
struct RunSkill {
  std::string skill;
  std::vector<operations::Parameter> parameters;
};
/// The files by their names; `main` is the one to run.
struct LoadOperation {
  std::map<std::string, std::string> files;
  std::string main;
};
/// run: from where the token is, after the end from START. resume: only what is paused or stopped.
struct RunOperation {
  enum class How { run, step, resume };
  How how = How::run;
};
/// After the current skill.
struct Pause {};
/// At once: the current skill is cut off.
struct Stop {};
struct PutToken {
  std::string icon;
};
struct SetParameter {
  std::string icon, parameter;
  operations::Value value;
};
struct SetBreakpoint {
  operations::Breakpoint breakpoint;
};
struct ClearBreakpoints {};

using Command = std::variant<TakeControls, ReleaseControls, RunSkill, LoadOperation, RunOperation, Pause,
                             Stop, PutToken, SetParameter, SetBreakpoint, ClearBreakpoints>;

/// How a command ended that was obeyed. Of RunSkill: what came of the skill.
struct Done {
  operations::SkillResult result;
  Duration begin{}, end{};
};

/// Why it was not obeyed. Nothing has moved then.
struct Refusal {
  enum class Why {
    not_yours,  // another client has the controls
    busy,       // a skill or an operation runs
    nothing,    // there is nothing to run, pause or resume
    wrong,      // the skill, parameter, icon or operation is wrong
    ending      // the server ends
  };
  Why why = Why::wrong;
  std::string message;
};

using Reply = std::variant<Done, Refusal>;
/// Called once, by any thread; must not call the desk.
using Answerer = std::function<void(const Reply&)>;

}  // namespace pal::server
