#include "tests/unit/chart/signs_trace.hpp"

namespace pal::analyzer::chart {

trace::Trace signs_trace() {
  using trace::Kind;
  trace::Trace trace;
  trace.skill = "signs";
  trace.environment = "bench";
  trace.origin = "predicted";
  // 0, 1 share a processor; 2 has its own; 3 and 4 are devices.
  trace.actors = {{"SM1", false, "P0", 1},
                  {"LS1", false, "P0", 2},
                  {"MC1", false, "P1", 1},
                  {"alter", true, "", 0},
                  {"range-finder", true, "", 0}};
  trace.statements = {{"SM1", "plan-path", "signs.pal", 4},
                      {"SM1", "TXM( motion to MC1 )", "signs.pal", 5},
                      {"SM1", "SPC( pc-done = TRUE )", "signs.pal", 6},
                      {"SM1", "TXM( Completion Protocol 0 )", "signs.pal", 7},
                      {"LS1", "WTM( profile from range-finder )", "signs.pal", 12},
                      {"LS1", "interpret", "signs.pal", 13},
                      {"MC1", "WTM( motion from SM1 ) WITHIN 4 ms", "signs.pal", 20},
                      {"MC1", "hold", "signs.pal", 21},
                      {"MC1", "UNTIL( pc-done )", "signs.pal", 22},
                      {"SM1", "TXM( request image from LS1 )", "signs.pal", 3}};
  trace.channels = {{"SM1", "motion", "MC1"},
                    {"range-finder", "profile", "LS1"},
                    {"alter", "tick", "MC1"},
                    {"SM1", "request image", "LS1"}};
  trace.conditions = {"pc-done"};
  trace.faults = {"alter: no answer within 20 ms"};
  const auto ms = [](double value) { return static_cast<std::int64_t>(value * 1'000'000 + 0.5); };
  trace.events = {
      {ms(0), Kind::block, 1, 4, 1, 0},  // LS1 waits for a profile
      {ms(0), Kind::block, 2, 6, 0, 0},  // MC1 waits for a motion, 4 ms at most
      {ms(0), Kind::start, 0, 9, -1, 0},   {ms(0.5), Kind::put, 0, 9, 3, 1},
      {ms(0.5), Kind::done, 0, 9, -1, 0},  {ms(0.5), Kind::start, 0, 0, -1, 0},
      {ms(1), Kind::busy, 4, -1, -1, 0},   {ms(1.5), Kind::put, 3, -1, 2, 1},
      {ms(3), Kind::put, 4, -1, 1, 1},     {ms(3), Kind::idle, 4, -1, -1, 0},
      {ms(3), Kind::stop, 0, 0, -1, 0},  // LS1 takes the processor
      {ms(3), Kind::start, 1, 4, -1, 0},   {ms(3.5), Kind::take, 1, 4, 1, 1},
      {ms(3.5), Kind::done, 1, 4, -1, 0},  {ms(3.5), Kind::start, 1, 5, -1, 0},
      {ms(4), Kind::give_up, 2, 6, 0, 0},  {ms(4), Kind::start, 2, 6, -1, 0},
      {ms(4.3), Kind::drop, 2, 6, 3, 1},   {ms(4.3), Kind::done, 2, 6, -1, 0},
      {ms(4.3), Kind::start, 2, 7, -1, 0}, {ms(5.5), Kind::overrun, 3, -1, 2, 0},
      {ms(6), Kind::done, 2, 7, -1, 0},    {ms(6), Kind::done, 1, 5, -1, 0},
      {ms(6), Kind::cancel, 1, -1, -1, 0}, {ms(6), Kind::start, 0, 0, -1, 0},
      {ms(7.5), Kind::done, 0, 0, -1, 0},  {ms(7.5), Kind::start, 0, 1, -1, 0},
      {ms(7.8), Kind::put, 0, 1, 0, 1},    {ms(7.8), Kind::done, 0, 1, -1, 0},
      {ms(7.8), Kind::start, 0, 2, -1, 0}, {ms(8.2), Kind::set, 0, 2, 0, 1},
      {ms(8.2), Kind::done, 0, 2, -1, 0},  {ms(8.2), Kind::start, 0, 3, -1, 0},
      {ms(8.2), Kind::start, 2, 8, -1, 0}, {ms(8.6), Kind::read, 2, 8, 0, 1},
      {ms(8.6), Kind::done, 2, 8, -1, 0},  {ms(9), Kind::complete, 0, 3, -1, 0},
      {ms(9), Kind::done, 0, 3, -1, 0},    {ms(9.5), Kind::fault, 3, -1, -1, 0},
  };
  return trace;
}

}  // namespace pal::analyzer::chart
