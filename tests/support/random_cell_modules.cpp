// What the modules do.
#include "tests/support/random_cell.hpp"

#include <utility>

namespace pal::test {

std::string RandomCell::bodies() {
  sets_ = executes_ = false;
  std::string out;
  if (!lonely_) out += sensors();
  out += controller();
  return out + method();
}

std::string RandomCell::sensors() {
  std::string out;
  if (sensor_ == 3) {
    begin({"filter"}, {"request raw from gauge", "raw to LS1"}, {"raw from gauge", "request raw from LS1"});
    backbone_ = {
        "WTM( request raw from LS1 )\nTXM( request raw from gauge )\nWTM( raw from gauge )\nTXM( raw to "
        "LS1 )\n"};
    out +=
        "Sensor Driver: SD1\nACTIVITY filter\nBEGIN\nREPEAT\n" + mixed(backbone_) + "UNTIL( forever )\nEND\n";
  } else {
    out += "Sensor Driver: SD1\n";
  }
  begin({"extract"}, {"force to SM1"}, {"request force from SM1", "raw from SD1"});
  const bool asks = sensor_ != 2 || asks_events_;
  if (asks) sends_.push_back("request raw from SD1");
  std::string get = asks ? "TXM( request raw from SD1 )\nWTM( raw from SD1 )\n" : "WTM( raw from SD1 )\n";
  if (sensor_ == 4) {
    sends_.push_back("request extra from SD1");
    waits_.push_back("extra from SD1");
    get =
        "TXM( request raw from SD1 )\nTXM( request extra from SD1 )\nWTM( raw from SD1 )\nWTM( extra "
        "from SD1 )\n";
  }
  backbone_ = {get, "extract\n"};
  Lines lines = chance_(3) == 0 ? Lines{get, "WTM( request force from SM1 )\n", "TXM( force to SM1 )\n"}
                                : Lines{"WTM( request force from SM1 )\n", get, "TXM( force to SM1 )\n"};
  out += "Logical Sensor: LS1\nACTIVITY extract\nBEGIN\nREPEAT\n" + mixed(lines) + "UNTIL( forever )\nEND\n";
  return out;
}

std::string RandomCell::controller() {
  std::string out = "Machine Controller: MC1\n";
  if (!controller_) return out;
  begin({"obey"}, {"correction to robot", "request motion from SM1"}, {"motion from SM1", "tick from robot"});
  backbone_ = {"TXM( request motion from SM1 )\nWTM( motion from SM1 )\n", "TXM( correction to robot )\n"};
  Lines lines = {"WTM( tick from robot )\n", "TXM( request motion from SM1 )\n", wait("motion from SM1", 1),
                 "TXM( correction to robot )\n"};
  return out + "ACTIVITY obey\nBEGIN\nREPEAT\n" + mixed(lines) + "UNTIL( forever )\nEND\n";
}

std::string RandomCell::method() {
  sets_ = executes_ = true;
  begin({"think", "prepare"}, {"motion to MC1"}, {"request motion from MC1"});
  const std::string act =
      std::string(chance_(2) == 0 ? "RPC( c )\n" : "") + "WTM( request motion from MC1 )\n" +
      (chance_(2) == 0 ? "CASE\n( c ):\nSPC( d = TRUE )\n( c = FALSE ):\nDo Nothing\nEND CASE\n" : "") +
      "TXM( motion to MC1 )\n";
  std::string sense = "SPC( c )\n";
  if (!lonely_) {
    sends_.push_back("request force from LS1");
    waits_.push_back("force from LS1");
    sense = "TXM( request force from LS1 )\nWTM( force from LS1 )\nSPC( c )\n";
  }
  backbone_ = {act, sense};
  executes_ = false;
  activities_ = {"recover"};
  const std::string executed = "Contingency Module: CM1\nACTIVITY recover\nBEGIN\nrecover\n" + mixed({act}) +
                               executed_blocks() + "END\n";
  executes_ = true;
  activities_ = {"think", "prepare"};
  std::string method;
  if (chance_(2) == 0) {
    method = "CONCURRENT\nBEGIN\nREPEAT\n" + mixed({sense}) + call() +
             "UNTIL( forever )\nEND\nBEGIN\nREPEAT\n" + call() + mixed({act, "SPC( d )\n"}) +
             "UNTIL( d )\nEND\nEND CONCURRENT\n";
  } else {
    method = "REPEAT\n" + mixed({sense, act, "SPC( d )\n"}) + "UNTIL( d )\n";
  }
  if (blocks_ && executed_() % 2 == 0)
    method += "CONCURRENT\nBEGIN\n" + call() + "think\nEND\nBEGIN\nExecute CM1\nEND\nEND CONCURRENT\n";
  if (chance_(3) == 0) method = few(deep_) + method;
  if (chance_(3) == 0) method += few(deep_);
  return executed +
         "Skill Module: SM1\nACTIVITY think\nACTIVITY prepare\nBEGIN\nWTM( Coordinator )\nExecute "
         "CM1\nthink\n" +
         method + (chance_(5) != 0 ? "TXM( Completion Protocol 0 )\n" : "") + "END\n";
}

std::string RandomCell::executed_blocks() {
  blocks_ = executed_() % 4 == 0;
  if (!blocks_) return "";
  const auto some = [this] {
    Lines lines = {"recover\n",
                   "RPC( c )\n",
                   "TXM( motion to MC1 )\n",
                   "WTM( request motion from MC1 ) WITHIN 1 ms\nrecover\nELSE\nDo Nothing\nEND WTM\n",
                   "REPEAT\nrecover\nUNTIL( d )\n",
                   "CONCURRENT\nBEGIN\nrecover\nEND\nBEGIN\nSPC( d )\nEND\nEND CONCURRENT\n",
                   "REPEAT\nrecover\nUNTIL( forever )\n"};
    if (!lonely_) lines.insert(lines.begin(), "TXM( request force from LS1 )\n");
    if (!lonely_) lines.insert(lines.begin(), "TXM( request force from LS1 )\nWTM( force from LS1 )\n");
    std::string out;
    for (auto count = 1 + executed_() % 2; count > 0; --count) out += lines[executed_() % lines.size()];
    return out;
  };
  return "CONCURRENT\nBEGIN\n" + some() + "END\nBEGIN\n" + some() + "END\nEND CONCURRENT\n";
}

void RandomCell::begin(Lines activities, Lines sends, Lines waits) {
  activities_ = std::move(activities);
  sends_ = std::move(sends);
  waits_ = std::move(waits);
  backbone_.clear();
}

}  // namespace pal::test
