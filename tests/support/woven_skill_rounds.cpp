// What the rounds of the modules are made of.
#include "tests/support/woven_skill.hpp"

namespace pal::test {

const WovenSkill::Call& WovenSkill::next_call(Module& in) {
  return in.called < in.calls.size() ? in.calls[in.called++] : chance_.one_of(in.calls);
}

const std::string& WovenSkill::next_send(Module& in) {
  if (in.sent < in.sends.size()) return in.sends[in.sent++];
  return in.sends[static_cast<std::size_t>(chance_(static_cast<int>(in.sends.size())))];
}

std::string WovenSkill::stuff(Module& in, const std::string& indent, int depth) {
  std::string out;
  for (int i = chance_.between(1, 3); i > 0; --i) {
    const bool calls = in.called < in.calls.size() || (!in.calls.empty() && chance_(6) == 0);
    const bool sends = in.sent < in.sends.size() || (!in.sends.empty() && chance_(8) == 0);
    if (calls && chance_(2) == 0) {
      out += asks(in, next_call(in), indent, depth);
    } else if (sends && chance_(2) == 0) {
      out += say(in, next_send(in), indent);
    } else if (depth == 0 && chance_(10) == 0) {
      const std::string yes = stuff(in, indent + "    ", 2);
      out += choice(in, yes, small(in, indent + "    "), indent);
    } else if (depth == 0 && chance_(14) == 0) {
      out += blocks(work(in, indent + "  ") + small(in, indent + "  "), small(in, indent + "  "), indent);
    } else {
      out += small(in, indent);
    }
  }
  return out;
}

std::string WovenSkill::rest(Module& in, const std::string& indent, int depth) {
  std::string out;
  while (in.called < in.calls.size()) out += asks(in, in.calls[in.called++], indent, depth);
  while (in.sent < in.sends.size()) out += say(in, in.sends[in.sent++], indent);
  return out;
}

std::string WovenSkill::round(Module& in, const Trigger& trigger, bool last, const std::string& indent,
                              int depth) {
  std::string out = stuff(in, indent, depth);
  if (last) out += rest(in, indent, depth);
  if (!trigger.reply.empty()) {
    out += say(in, trigger.reply, indent);
    if (chance_(4) == 0) out += small(in, indent);
  } else if (chance_(3) == 0) {
    out += work(in, indent);
  }
  return out;
}

std::string WovenSkill::loop(const std::string& inside, const std::string& indent, const Module& in) {
  return indent + "REPEAT\n" + inside + indent +
         (chance_(10) == 0 ? "UNTIL( " + condition(in, 4) + " )\n" : "UNTIL( forever )\n");
}

std::string WovenSkill::body(Module& in) {
  std::string out = head(in.kind, in.name) + "BEGIN\n";
  const bool method = in.name == "SM1";
  if (method) out += "  WTM( Coordinator )\n";
  if (chance_(5) == 0) out += stuff(in, "  ", 0);
  const std::size_t count = in.triggers.size();
  const int form = count == 0 ? 3 : count == 1 ? (chance_(4) == 0 ? 2 : 0) : chance_(3);
  std::string loops;
  if (form == 3) {
    // It goes on by itself.
    std::string inside;
    if (!in.calls.empty()) {
      const Call& call = in.calls[in.called < in.calls.size() ? in.called++ : 0];
      inside = ask(in, call, "    ") + take(in, call, "    ");
    }
    loops += loop(inside + rest(in, "    ", 0) + stuff(in, "    ") + work(in, "    "), "  ", in);
  } else if (form == 0) {
    // All in one loop, one after the other.
    std::string inside;
    for (std::size_t i = 0; i < count; ++i) {
      inside += say(in, "WTM( " + in.triggers[i].wait + " )", "    ");
      inside += round(in, in.triggers[i], i + 1 == count, "    ", 0);
    }
    loops += loop(inside, "  ", in);
  } else if (form == 1) {
    // The first of them.
    std::string inside = "    WTM FIRST\n";
    for (std::size_t i = 0; i < count; ++i) {
      inside += "      ( " + in.triggers[i].wait + " ):\n";
      inside += round(in, in.triggers[i], i + 1 == count, "        ", 1);
    }
    loops += loop(inside + "    END WTM\n", "  ", in);
  } else {
    // A block each.
    loops += "  CONCURRENT\n";
    for (std::size_t i = 0; i < count; ++i) {
      loops += "  BEGIN\n" +
               loop(say(in, "WTM( " + in.triggers[i].wait + " )", "      ") +
                        round(in, in.triggers[i], i + 1 == count, "      ", 2),
                    "    ", in) +
               "  END\n";
      blocks_.push_back(in.name + "." + std::to_string(i + 1));
    }
    if (chance_(3) == 0) loops += "  BEGIN\n" + work(in, "    ") + small(in, "    ") + "  END\n";
    loops += "  END CONCURRENT\n";
  }
  out += loops;
  if (method) out += (chance_(2) == 0 ? work(in, "  ") : "") + "  TXM( Completion Protocol 0 )\n";
  return out + "END\n";
}

}  // namespace pal::test
