// What the modules do a little of, and how one asks another.
#include "tests/support/woven_skill.hpp"

namespace pal::test {

std::string WovenSkill::take(const Module& in, const Call& call, const std::string& indent) {
  const std::string wait = answer_of(call);
  if (chance_(8) != 0) return say(in, wait, indent);
  return indent + wait + " WITHIN " + std::to_string(chance_(3) == 0 ? 0 : chance_.between(1, 12)) + " ms\n" +
         small(in, indent + "  ") + indent + "ELSE\n" + small(in, indent + "  ") + indent + "END WTM\n";
}

std::string WovenSkill::set_or_read(const Module& in, const std::string& indent) {
  if (chance_(2) == 0) return indent + "SPC( c" + in.name + " )\n";
  const Module& other = chance_.one_of(modules_);
  read_.emplace_back(in.name, "c" + other.name);
  return indent + "RPC( c" + other.name + " )\n";
}

std::string WovenSkill::small(const Module& in, const std::string& indent) {
  if (calm_ && chance_(2) == 0) return set_or_read(in, indent);
  switch (chance_(6)) {
    case 0:
      return indent + "SPC( c" + in.name +
             (chance_(2) == 0   ? ""
              : chance_(2) == 0 ? " = TRUE"
                                : " = FALSE") +
             " )\n";
    case 1:
      return indent + "RPC( " + condition(in, 4) + " )\n";
    case 2:
      return indent + "Do Nothing\n";
    default:
      return work(in, indent);
  }
}

std::string WovenSkill::choice(const Module& in, const std::string& yes, const std::string& no,
                               const std::string& indent) {
  const std::string c = condition(in, 4);
  return cases(c, yes, "NOT " + c, no, indent);
}

std::string WovenSkill::blocks(const std::string& one, const std::string& other, const std::string& indent) {
  return concurrent({one, other}, indent);
}

std::string WovenSkill::asks(const Module& in, const Call& call, const std::string& indent, int depth) {
  const std::string more = indent + "  ";
  switch (depth > 1 ? chance_(7) : chance_(18)) {
    case 7:
      return blocks(ask(in, call, more) + small(in, more),
                    small(in, more) + take(in, call, more) + work(in, more), indent);
    case 8:
      return blocks(more + "REPEAT\n" + ask(in, call, more + "  ") + take(in, call, more + "  ") +
                        small(in, more + "  ") + more + "UNTIL( forever )\n",
                    work(in, more) + small(in, more), indent);
    case 9: {
      const std::string c = "c" + in.name;
      const std::string deep = more + "  ";
      return indent + "CASE\n" + more + "( " + c + " ):\n" + take(in, call, deep) + work(in, deep) + deep +
             "SPC( " + c + " = FALSE )\n" + more + "( NOT " + c + " ):\n" + ask(in, call, deep) + deep +
             "SPC( " + c + " = TRUE )\n" + indent + "END CASE\n";
    }
    case 10:
      return choice(in, ask(in, call, more + "  ") + take(in, call, more + "  ") + small(in, more + "  "),
                    small(in, more + "  "), indent);
    case 11:
      return blocks(ask(in, call, more) + take(in, call, more), work(in, more), indent);
    default:
      return ask(in, call, indent) + (chance_(2) == 0 ? small(in, indent) : "") + take(in, call, indent);
  }
}

}  // namespace pal::test
