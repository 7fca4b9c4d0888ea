// Statements of every kind.
#include "tests/support/random_cell.hpp"

namespace pal::test {

std::string RandomCell::guard() {
  switch (chance_(5)) {
    case 0:
      return "c AND NOT ( d )";
    case 1:
      return "c OR d";
    case 2:
      return "c = FALSE";
    case 3:
      return "d";
    default:
      return "c";
  }
}

std::string RandomCell::wait(const std::string& what, int deeper) {
  if (chance_(4) != 0) return "WTM( " + what + " )\n";
  const int limit = chance_(3) == 0 ? 0 : chance_.between(0, longest_);
  return "WTM( " + what + " ) WITHIN " + ms(limit) + "\n" + few(deeper) + "ELSE\n" + few(deeper) +
         "END WTM\n";
}

std::string RandomCell::few(int deeper) {
  std::string out;
  for (int count = chance_(3); count > 0; --count) out += statement(deeper);
  return out;
}

std::string RandomCell::statement(int deeper) {
  const int kind = chance_(deeper <= 0 ? 8 : 14);
  switch (kind) {
    case 0:
      return "Do Nothing\n";
    case 1:
    case 2:
      return chance_.one_of(activities_) + "\n";
    case 3:
      return sets_ ? chance_.one_of({"SPC( c )\n", "SPC( d )\n", "SPC( c = TRUE )\n"})
                   : chance_.one_of(activities_) + "\n";
    case 4:
      return chance_.one_of({"RPC( c )\n", "RPC( d )\n"});
    case 5:
      return "TXM( " + chance_.one_of(sends_) + " )\n";
    case 6:
      return wait(chance_.one_of(waits_), deeper - 1);
    case 7:
      return executes_ ? "Execute CM1\n" : chance_.one_of(activities_) + "\n";
    case 8: {
      const std::string out = "CASE\n( " + guard() + " ):\n" + few(deeper - 1);
      const bool total = chance_(4) != 0;
      return out + (total ? "( c OR NOT ( c ) ):\nDo Nothing\n" : "") + "END CASE\n";
    }
    case 9:
      return "REPEAT\n" + few(deeper - 1) + chance_.one_of(activities_) + "\nUNTIL( " + guard() + " )\n";
    case 10:
    case 11: {
      std::string out = "CONCURRENT\n";
      for (int blocks = chance_.between(1, 2 + chance_(2)); blocks > 0; --blocks) {
        const bool forever = chance_(3) == 0;
        out += "BEGIN\n" + std::string(forever ? "REPEAT\n" : "") + few(deeper - 1) +
               (forever ? chance_.one_of(activities_) + "\n" : "") +
               (chance_(2) == 0 && !backbone_.empty() ? chance_.one_of(backbone_) : "") +
               (forever ? "UNTIL( forever )\n" : "") + "END\n";
      }
      return out + "END CONCURRENT\n";
    }
    case 12: {
      if (waits_.size() < 2) return wait(waits_.front(), deeper - 1);
      const bool limited = chance_(2) == 0;
      std::string out =
          "WTM FIRST" + (limited ? " WITHIN " + ms(chance_.between(0, longest_)) : std::string()) + "\n";
      Lines each = waits_;
      if (each.size() > 2 && chance_(2) == 0)
        each.erase(each.begin() + chance_(static_cast<int>(each.size())));
      chance_.shuffle(each);
      for (const std::string& what : each) out += "( " + what + " ):\n" + few(deeper - 1);
      return out + (limited ? "ELSE\n" + few(deeper - 1) : "") + "END WTM\n";
    }
    default:
      return backbone_.empty() ? std::string("Do Nothing\n") : chance_.one_of(backbone_);
  }
}

std::string RandomCell::mixed(Lines lines) {
  if (chance_(6) == 0 && lines.size() > 1) std::swap(lines[0], lines[1]);
  std::string out;
  for (const std::string& line : lines) {
    if (chance_(4) == 0) out += statement(deep_);
    out += line;
  }
  if (chance_(5) == 0) out += statement(deep_);
  return out;
}

}  // namespace pal::test
