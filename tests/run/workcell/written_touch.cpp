#include "tests/run/workcell/written_touch.hpp"

#include <algorithm>
#include <cmath>

namespace pal::test {

using namespace std::chrono_literals;
using runtime::Task;
using runtime::Thread;

namespace {

constexpr double cycle = 0.028;  // s, of ALTER

enum Channel {
  start_force,
  zforce,
  ask_wrench,
  wrench,
  ask_device,
  device_wrench,
  tick,
  ask_motion,
  motion,
  correction
};
enum Condition { pc_force, pc_reach, pc_home };
enum ThreadIndex { thread_sm1, thread_sense, thread_move, thread_ls1, thread_mc1, thread_sd1 };
enum Statement {
  s_start,
  s_ask,
  s_take,
  s_set,
  s_unset,  // SM1, before
  b_ask,
  b_take,
  b_set,  // SM1.1
  m_wait,
  m_read,
  m_case,
  m_still,
  m_advance,
  m_send,
  m_reach,
  m_until,  // SM1.2
  s_concurrent,
  s_case,
  s_taken,
  s_done,
  s_gone_back,
  s_gave_up,  // SM1, after
  c_wait,
  c_retreat,
  c_send,
  c_home,
  c_until,  // CM1
  l_wait,
  l_ask,
  l_take,
  l_extract,
  l_send,  // LS1
  a_tick,
  a_ask,
  a_take,
  a_obey,
  a_hold,
  a_send,  // MC1
  d_wait,
  d_ask,
  d_take,
  d_send  // SD1
};

const std::vector<runtime::Field> force_fields{{"value", "N"}, {"greatest", "N"}};
const std::vector<runtime::Field> motion_fields{{"dx", "mm"},  {"dy", "mm"},  {"dz", "mm"},
                                                {"rx", "deg"}, {"ry", "deg"}, {"rz", "deg"}};
const std::vector<runtime::Field> wrench_fields{{"fx", "N"},   {"fy", "N"},   {"fz", "N"},
                                                {"tx", "N*m"}, {"ty", "N*m"}, {"tz", "N*m"}};
const std::vector<runtime::ProcessorSpec> processors{{"P0"}, {"P1"}, {"P2"}, {"P3"}};
const std::vector<runtime::ThreadSpec> threads{
    {"SM1", 0, 1}, {"SM1.1", 0, 1, 0, false}, {"SM1.2", 0, 1, 0, true}, {"LS1", 3, 2}, {"MC1", 2, 1},
    {"SD1", 3, 1}};
const std::vector<std::string_view> conditions{"pc-force", "pc-reach", "pc-home"};
const std::vector<std::string_view> devices{"force-torque", "alter"};
const std::vector<runtime::CompletionSpec> completions{
    {0, runtime::CompletionSpec::Kind::normal, "touches"},
    {1, runtime::CompletionSpec::Kind::contingency, "nothing met"},
    {2, runtime::CompletionSpec::Kind::error, "error"}};
const std::vector<runtime::ParameterSpec> parameters{
    {"approach-speed", runtime::ParameterType::real, "mm/s", 1, 60, 20, ""},
    {"reach", runtime::ParameterType::real, "mm", 1, 300, 60, ""},
    {"threshold", runtime::ParameterType::real, "N", 1, 40, 5, ""}};

}  // namespace

int WrittenTouch::statement(std::string_view module, std::string_view text, int line, runtime::Time best,
                            runtime::Time worst) {
  statements_.push_back({module, text, "written.pal", line, {best, worst}});
  return static_cast<int>(statements_.size()) - 1;
}

WrittenTouch::WrittenTouch(bool read_first) : read_first_(read_first) {
  const auto cost = 50us;
  int line = 0;
  const auto add = [&](std::string_view module, std::string_view text, runtime::Time best,
                       runtime::Time worst) { statement(module, text, ++line, best, worst); };
  const auto fixed = [&](std::string_view module, std::string_view text) { add(module, text, cost, cost); };
  add("SM1", "WTM( Coordinator )", 0us, 0us);
  for (const char* text :
       {"TXM( request Zforce from LS1 )", "WTM( Zforce from LS1 )", "SPC( pc-force )",
        "SPC( pc-reach = FALSE )", "TXM( request Zforce from LS1 )", "WTM( Zforce from LS1 )",
        "SPC( pc-force )", "WTM( motion request from MC1 )", "RPC( pc-force )", "CASE"})
    fixed("SM1", text);
  add("SM1", "stand-still", 100us, 100us);
  add("SM1", "advance", 100us, 300us);
  for (const char* text : {"TXM( motion to MC1 )", "SPC( pc-reach )", "UNTIL( pc-force OR pc-reach )"})
    fixed("SM1", text);
  add("SM1", "CONCURRENT", 0us, 0us);
  for (const char* text : {"CASE", "WTM( motion request from MC1 )", "TXM( Completion Protocol 0 )",
                           "WTM( motion request from MC1 )", "TXM( Completion Protocol 1 )"})
    fixed("SM1", text);
  fixed("CM1", "WTM( motion request from MC1 )");
  add("CM1", "retreat", 100us, 300us);
  for (const char* text : {"TXM( motion to MC1 )", "SPC( pc-home )", "UNTIL( pc-home )"}) fixed("CM1", text);
  for (const char* text :
       {"WTM( request Zforce from SM1 )", "TXM( request wrench from SD1 )", "WTM( wrench from SD1 )"})
    fixed("LS1", text);
  add("LS1", "extract-z", 100us, 200us);
  fixed("LS1", "TXM( Zforce to SM1 )");
  for (const char* text :
       {"WTM( tick from alter )", "TXM( request motion from SM1 )", "WTM( motion from SM1 ) WITHIN 4 ms"})
    fixed("MC1", text);
  add("MC1", "obey", 100us, 200us);
  add("MC1", "hold", 100us, 100us);
  fixed("MC1", "TXM( correction to alter )");
  for (const char* text : {"WTM( request wrench from LS1 )", "TXM( request wrench from force-torque )",
                           "WTM( wrench from force-torque )", "TXM( wrench to LS1 )"})
    fixed("SD1", text);

  channels_ = {{"SM1", "request Zforce", "LS1", {}, zforce, true},
               {"LS1", "Zforce", "SM1", force_fields},
               {"LS1", "request wrench", "SD1", {}, wrench, true},
               {"SD1", "wrench", "LS1", wrench_fields},
               {"SD1", "request wrench", "force-torque", {}, device_wrench, true, false, true},
               {"force-torque", "wrench", "SD1", wrench_fields, -1, false, true, false},
               {"alter", "tick", "MC1", {}, -1, false, true, false},
               {"MC1", "request motion", "SM1", {}, motion, true},
               {"SM1", "motion", "MC1", motion_fields},
               {"MC1", "correction", "alter", motion_fields, -1, false, false, true}};
  const std::string_view name = read_first_ ? "touch-read-first" : "touch";
  wiring_ = {name,      "workcell", processors, threads,      statements_,
             channels_, conditions, devices,    {cost, cost}, {{}, {0us, 50us}}};
  description_ = {name, "workcell", {}, parameters, completions};
}

void WrittenTouch::set_parameter(std::string_view name, double value) {
  for (const runtime::ParameterSpec& parameter : parameters)
    if (parameter.name == name) runtime::check_parameter(parameter, value);
  if (name == "approach-speed")
    speed = value;
  else if (name == "reach")
    reach = value;
  else if (name == "threshold")
    threshold = value;
  else
    runtime::unknown_parameter(description_, name);
}

void WrittenTouch::start() {
  moved_ = 0;
  stood_ = 0;
}

Task WrittenTouch::body(std::size_t index, Thread& thread) {
  switch (index) {
    case thread_sm1:
      return sm1(thread);
    case thread_sense:
      return sm1_sense(thread);
    case thread_move:
      return read_first_ ? sm1_move_read_first(thread) : sm1_move(thread);
    case thread_ls1:
      return ls1(thread);
    case thread_mc1:
      return mc1(thread);
    default:
      return sd1(thread);
  }
}

Task WrittenTouch::sm1(Thread& thread) {
  co_await thread.take_start(s_start);
  co_await thread.send(s_ask, start_force);
  co_await thread.wait(s_take, runtime::from(zforce, known_));
  co_await thread.set(s_set, pc_force, [this] { return known_.values[0] >= threshold; });
  co_await thread.set(s_unset, pc_reach, [] { return false; });
  co_await thread.concurrent(s_concurrent, thread_sense, thread_move);
  co_await thread.test(s_case, pc_force, pc_reach);
  if (thread.tested(pc_force) || !thread.tested(pc_reach)) {
    co_await thread.wait(s_taken, runtime::from(ask_motion));
    co_await thread.complete(s_done, 0);
  } else {
    co_await cm1(thread);
    co_await thread.wait(s_gone_back, runtime::from(ask_motion));
    co_await thread.complete(s_gave_up, 1);
  }
}

Task WrittenTouch::sm1_sense(Thread& thread) {
  for (;;) {
    co_await thread.send(b_ask, start_force);
    co_await thread.wait(b_take, runtime::from(zforce, known_));
    co_await thread.set(b_set, pc_force, [this] { return known_.values[0] >= threshold; });
  }
}

Task WrittenTouch::sm1_move(Thread& thread) {
  for (;;) {
    co_await thread.wait(m_wait, runtime::from(ask_motion));
    co_await thread.read(m_read, pc_force);
    co_await thread.test(m_case, pc_force);
    if (thread.tested(pc_force)) {
      co_await thread.perform(m_still, [this] { motion_ = {}; });
      co_await thread.send(m_send, motion, motion_);
    } else {
      co_await thread.perform(m_advance, [this] {
        motion_ = {};
        motion_.values[2] = std::min(speed * cycle, reach - moved_);
        moved_ += motion_.values[2];
        stood_ += motion_.values[2] <= 0;
      });
      co_await thread.send(m_send, motion, motion_);
      co_await thread.set(m_reach, pc_reach, [this] { return stood_ >= 3; });
    }
    co_await thread.test(m_until, pc_force, pc_reach);
    if (thread.tested(pc_force) || thread.tested(pc_reach)) co_return;
  }
}

Task WrittenTouch::sm1_move_read_first(Thread& thread) {
  for (;;) {
    co_await thread.read(m_read, pc_force);
    co_await thread.test(m_case, pc_force);
    if (!thread.tested(pc_force)) {
      co_await thread.wait(m_wait, runtime::from(ask_motion));
      co_await thread.perform(m_advance, [this] {
        motion_ = {};
        motion_.values[2] = std::min(speed * cycle, reach - moved_);
        moved_ += motion_.values[2];
        stood_ += motion_.values[2] <= 0;
      });
      co_await thread.send(m_send, motion, motion_);
      co_await thread.set(m_reach, pc_reach, [this] { return stood_ >= 3; });
    }
    co_await thread.test(m_until, pc_force, pc_reach);
    if (thread.tested(pc_force) || thread.tested(pc_reach)) co_return;
  }
}

Task WrittenTouch::cm1(Thread& thread) {
  for (;;) {
    co_await thread.wait(c_wait, runtime::from(ask_motion));
    co_await thread.perform(c_retreat, [this] {
      motion_ = {};
      motion_.values[2] = -std::min(speed * cycle, moved_);
      moved_ += motion_.values[2];
    });
    co_await thread.send(c_send, motion, motion_);
    co_await thread.set(c_home, pc_home, [this] { return motion_.values[2] == 0; });
    co_await thread.test(c_until, pc_home);
    if (thread.tested(pc_home)) co_return;
  }
}

Task WrittenTouch::ls1(Thread& thread) {
  for (;;) {
    co_await thread.wait(l_wait, runtime::from(start_force));
    co_await thread.send(l_ask, ask_wrench);
    co_await thread.wait(l_take, runtime::from(wrench, seen_));
    co_await thread.perform(l_extract, [this] {
      force_.values = {-seen_.values[2], std::max({std::abs(seen_.values[0]), std::abs(seen_.values[1]),
                                                   std::abs(seen_.values[2])})};
    });
    co_await thread.send(l_send, zforce, force_);
  }
}

Task WrittenTouch::mc1(Thread& thread) {
  for (;;) {
    co_await thread.wait(a_tick, runtime::from(tick));
    co_await thread.send(a_ask, ask_motion);
    const int chosen = co_await thread.wait_within(a_take, 4ms, runtime::from(motion, obeyed_));
    if (chosen == 0)
      co_await thread.perform(a_obey, [this] { correction_ = obeyed_; });
    else
      co_await thread.perform(a_hold, [this] { correction_ = {}; });
    co_await thread.send(a_send, correction, correction_);
  }
}

Task WrittenTouch::sd1(Thread& thread) {
  for (;;) {
    co_await thread.wait(d_wait, runtime::from(ask_wrench));
    co_await thread.send(d_ask, ask_device);
    co_await thread.wait(d_take, runtime::from(device_wrench, wrench_));
    co_await thread.send(d_send, wrench, wrench_);
  }
}

}  // namespace pal::test
