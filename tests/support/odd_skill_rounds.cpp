// What the rounds of the modules are made of.
#include "tests/support/odd_skill.hpp"

namespace pal::test {

std::string OddSkill::stuff(Module& in, const std::string& indent) {
  std::vector<std::string> parts;
  for (const Call& call : in.calls) parts.push_back(asks(in, call, indent));
  for (const std::string& send : in.sends) {
    const std::string deep = indent + "    ";
    parts.push_back(chance_(3) == 0 ? choice(in, say(in, send, deep), deep + "Do Nothing\n", indent)
                                    : say(in, send, indent));
    if (odd(Odd::twice, 3)) parts.push_back(say(in, send, indent));
  }
  if (in.name == "SM1" && contingency_) {
    parts.push_back(indent + "Execute CM1\n");
    if (chance_(2) == 0)
      parts.push_back(concurrent({indent + "  Execute CM1\n", small(in, indent + "  ")}, indent));
  }
  for (int i = chance_.between(0, 2); i > 0; --i) parts.push_back(small(in, indent));
  if (calm_ && chance_(2) == 0) parts.push_back(say(in, "SPC( c" + in.name + " )", indent));
  if (calm_ && chance_(2) == 0) parts.push_back(say(in, "RPC( c" + any_module() + " )", indent));
  chance_.shuffle(parts);
  std::string out;
  for (const std::string& part : parts) out += part;
  return out;
}

std::string OddSkill::loop(const Module& in, const std::string& inside, const std::string& indent) {
  if (!odd(Odd::leaves, 3)) return forever(inside, indent);
  return indent + "REPEAT\n" + inside + indent + "  SPC( c" + in.name + " )\n" + indent + "UNTIL( c" +
         in.name + " )\n";
}

std::string OddSkill::polling(const Module& in, const std::string& indent) {
  const std::string more = indent + "  ";
  const Call& call = in.calls.front();
  std::vector<std::string> after = in.sends;
  if (chance_(3) != 0) after.push_back("w" + std::to_string(chance_.between(1, 3)) + in.name);
  chance_.shuffle(after);
  std::string inside = say(in, answer_of(call), more) + work(in, more) + ask(in, call, more);
  for (const std::string& each : after) inside += say(in, each, more);
  return ask(in, call, indent) + forever(inside, indent);
}

std::string OddSkill::rounds(Module& in, const std::string& indent) {
  std::vector<Trigger> triggers = in.triggers;
  chance_.shuffle(triggers);
  const std::string more = indent + "  ";
  const std::string deep = more + "    ";
  std::string inside;
  std::vector<std::string> beside;
  std::string before;
  std::vector<Trigger> arms;
  std::string within;
  for (std::size_t i = triggers.empty() ? 0 : 1; i < triggers.size(); ++i) {
    const Trigger& trigger = triggers[i];
    if (odd(Odd::within, 1)) {
      if (odd(Odd::before, 2)) before += limited(in, trigger.wait, serve(in, trigger, indent + "  "), indent);
      within += limited(in, trigger.wait, serve(in, trigger, more + "  "), more);
    } else if (odd(Odd::beside, 1)) {
      beside.push_back(loop(
          in, say(in, "WTM( " + trigger.wait + " )", more + "  ") + serve(in, trigger, more + "  "), more));
    } else {
      arms.push_back(trigger);
    }
  }
  if (polls_ == in.name && triggers.empty()) return polling(in, indent);
  const std::string work_of_round = stuff(in, more);
  if (triggers.empty()) {
    inside = say(in, "p" + in.name, more) + within + work_of_round;
  } else if (!arms.empty() || odd(Odd::arms, 2)) {
    arms.push_back(triggers.front());
    const bool gives_up = odd(Odd::arms, 2);
    inside = more + "WTM FIRST" +
             (gives_up ? " WITHIN " + std::to_string(chance_.between(2, 30)) + " ms\n" : "\n");
    for (const Trigger& arm : arms) inside += more + "  ( " + arm.wait + " ):\n" + serve(in, arm, deep);
    if (gives_up) inside += more + "ELSE\n" + small(in, deep);
    inside += more + "END WTM\n" + within + work_of_round;
  } else {
    const Trigger& trigger = triggers.front();
    inside = say(in, "WTM( " + trigger.wait + " )", more);
    const std::string answer = serve(in, trigger, more);
    inside += chance_(2) == 0 ? answer + within + work_of_round : within + work_of_round + answer;
  }
  const std::string main = loop(in, inside, indent);
  if (beside.empty() && (in.name != "SM1" || !odd(Odd::leaves, 1))) return before + main;
  std::vector<std::string> all = beside;
  all.push_back(main);
  if (chance_(4) == 0) all.push_back(work(in, more));
  for (std::size_t i = 0; i < all.size(); ++i) blocks_.push_back(in.name + "." + std::to_string(i + 1));
  return before + concurrent(all, indent);
}

std::string OddSkill::one_after_the_other(const Module& in) {
  const std::string deep = "      ";
  const std::string set = deep + "SPC( c" + in.name + " )\n";
  const std::string paced =
      in.calls.empty() ? say(in, "p" + in.name, deep)
                       : ask(in, in.calls.front(), deep) + say(in, answer_of(in.calls.front()), deep);
  std::string out =
      concurrent({forever(paced + set, "    "), work(in, "    ") + say(in, "p" + in.name, "    ")}, "  ");
  out += concurrent({say(in, "p" + in.name, "    ") + "    RPC( c" + in.name + " )\n" + work(in, "    "),
                     small(in, "    ")},
                    "  ");
  ages_.push_back("c" + in.name + " AT " + said_[said_.size() - 1].second + " IN " + in.name);
  return out;
}

std::string OddSkill::body(Module& in) {
  std::string out = head(in.kind, in.name) + "  ACTIVITY p" + in.name + "\nBEGIN\n";
  if (in.name == "SM1") out += "  WTM( Coordinator )\n";
  if (chance_(6) == 0) out += small(in, "  ");
  if (!in.sends.empty() && chance_(5) == 0) out += say(in, in.sends.front(), "  ");
  if (!in.calls.empty() && polls_ != in.name && chance_(8) == 0) out += asks(in, in.calls.front(), "  ");
  if (odd(Odd::leaves, 2)) out += one_after_the_other(in);
  out += rounds(in, "  ");
  if (in.name == "SM1") out += work(in, "  ") + "  TXM( Completion Protocol 0 )\n";
  return out + "END\n";
}

std::string OddSkill::contingency() {
  const std::string inside = chance_(2) == 0 ? "  w1CM1\n" : concurrent({"    w1CM1\n", "    w2CM1\n"}, "  ");
  said_.emplace_back("CM1", "w1CM1");
  return head("Contingency Module", "CM1") + "BEGIN\n" + inside + "END\n";
}

}  // namespace pal::test
