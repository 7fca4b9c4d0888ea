// What the modules do a little of, and how one asks another.
#include "tests/support/odd_skill.hpp"

namespace pal::test {

std::string OddSkill::small(const Module& in, const std::string& indent) {
  switch (chance_(7)) {
    case 0:
      if (chance_(2) == 0)
        return indent + "SPC( c" + in.name + (chance_(2) == 0 ? " = TRUE )\n" : " = FALSE )\n");
      return say(in, "SPC( c" + in.name + " )", indent);
    case 1:
      return say(in, "RPC( " + condition(in, 3) + " )", indent);
    case 2:
      return indent + "Do Nothing\n";
    case 3:
      return choice(in, work(in, indent + "    "), indent + "    Do Nothing\n", indent);
    default:
      return work(in, indent);
  }
}

std::string OddSkill::choice(const Module& in, const std::string& yes, const std::string& no,
                             const std::string& indent) {
  const std::string c = condition(in, 3);
  // The second arm may exclude the first, overlap with it, or leave something out.
  const std::string other = odd(Odd::tests, 3) ? condition(in, 3) : "NOT " + c;
  return cases(c, yes, other, no, indent);
}

std::string OddSkill::limited(const Module& in, const std::string& wait, const std::string& then,
                              const std::string& indent) {
  said_.emplace_back(in.name, "WTM( " + wait + " )");
  return indent + "WTM( " + wait + " ) WITHIN " +
         std::to_string(chance_(4) == 0 ? 0 : chance_.between(1, 8)) + " ms\n" +
         (then.empty() ? indent + "  Do Nothing\n" : then) + indent + "ELSE\n" + small(in, indent + "  ") +
         indent + "END WTM\n";
}

std::string OddSkill::serve(const Module& in, const Trigger& trigger, const std::string& indent) {
  std::string out = chance_(2) == 0 ? small(in, indent) : "";
  if (!trigger.reply.empty()) out += say(in, trigger.reply, indent);
  if (out.empty() || chance_(4) == 0) out += small(in, indent);
  return out;
}

std::string OddSkill::take(const Module& in, const Call& call, const std::string& indent) {
  if (!odd(Odd::limits, 2)) return say(in, answer_of(call), indent);
  return limited(in, call.message + " from " + call.server, small(in, indent + "  "), indent);
}

std::string OddSkill::asks(const Module& in, const Call& call, const std::string& indent) {
  const std::string more = indent + "  ";
  switch (odd(Odd::asks, 2) ? chance_(5) : 5) {
    case 0:
      // What is asked for is taken beside, or after.
      return ask(in, call, indent) + concurrent({small(in, more), take(in, call, more)}, indent);
    case 1:
      // Cancelled while it waits, or is answered.
      return concurrent(
          {forever(ask(in, call, more + "  ") + take(in, call, more + "  ") + work(in, more + "  "), more),
           work(in, more) + small(in, more)},
          indent);
    case 2:
      return choice(in, ask(in, call, more + "  ") + take(in, call, more + "  "), more + "  Do Nothing\n",
                    indent);
    case 3:
      return concurrent({ask(in, call, more) + take(in, call, more), work(in, more)}, indent);
    case 4:
      return take(in, call, indent) + small(in, indent) + ask(in, call, indent);
    default:
      return ask(in, call, indent) + (chance_(2) == 0 ? small(in, indent) : "") + take(in, call, indent);
  }
}

}  // namespace pal::test
