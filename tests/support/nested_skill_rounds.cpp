#include "tests/support/nested_skill.hpp"

#include <algorithm>
#include <utility>

namespace pal::test {

std::string NestedSkill::once(const Module& in, const Item& item, const std::string& indent) {
  const std::string with = " " + item.party + " )";
  switch (item.kind) {
    case Item::Kind::take: {
      const std::string reply =
          item.answered ? say(in, "TXM( " + item.message + " to" + with, indent) : smalls(in, 1, indent);
      return wait(in, (item.answered ? "request " : "") + item.message + " from " + item.party,
                  smalls(in, 1, indent) + reply, indent);
    }
    case Item::Kind::call:
      return say(in, "TXM( request " + item.message + " from" + with, indent) + smalls(in, 1, indent) +
             wait(in, item.message + " from " + item.party, "", indent);
    case Item::Kind::send:
      break;
  }
  return say(in, "TXM( " + item.message + " to" + with, indent);
}

std::string NestedSkill::leaf(const Module& in, const Item& item, bool last, const std::string& indent) {
  if (item.kind == Item::Kind::send || !odd(Odd::loops, 2)) return once(in, item, indent);
  const std::string inside = once(in, item, indent + "  ") + smalls(in, 1, indent + "  ");
  if (last && chance_(3) != 0) return indent + "REPEAT\n" + inside + indent + "UNTIL( forever )\n";
  return indent + "REPEAT\n" + inside + indent + "  SPC( c" + in.name + " )\n" + indent + "UNTIL( c" +
         in.name + " )\n";
}

std::string NestedSkill::complete(const Module& in, const std::string& indent) {
  if (in.name != "SM1" || !odd(Odd::endings, 2)) return "";
  const std::string deep = indent + "    ";
  return choice(in, deep + "TXM( Completion Protocol " + (chance_(2) == 0 ? "0" : "2") + " )\n",
                deep + "Do Nothing\n", indent);
}

std::string NestedSkill::tree(const Module& in, Items items, int depth, bool last,
                              const std::string& indent) {
  const std::string more = indent + "  ";
  chance_.shuffle(items);
  if (depth > 0 && odd(Odd::blocks, 2)) {
    const int count = chance_.between(2, 3);
    std::vector<Items> parts(static_cast<std::size_t>(count));
    for (const Item& item : items) parts[static_cast<std::size_t>(chance_(count))].push_back(item);
    std::string out = indent + "CONCURRENT\n";
    for (const Items& part : parts) {
      std::string block = part.empty() ? small(in, more) : tree(in, part, depth - 1, true, more);
      if (chance_(6) == 0) block += complete(in, more);
      out += indent + "BEGIN\n" + block + indent + "END\n";
    }
    return out + indent + "END CONCURRENT\n" + smalls(in, 1, indent);
  }
  if (depth > 0 && odd(Odd::branches, 3)) {
    Items parts[2];
    for (const Item& item : items) {
      parts[chance_(2)].push_back(item);
      if (chance_(2) == 0) parts[chance_(2)].push_back(item);
    }
    const std::string deep = indent + "    ";
    return choice(in, tree(in, parts[0], depth - 1, false, deep) + small(in, deep),
                  tree(in, parts[1], depth - 1, false, deep) + small(in, deep), indent);
  }
  std::string out;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool ends = last && i + 1 == items.size();
    out += depth > 0 && chance_(4) == 0 ? tree(in, {items[i]}, depth - 1, ends, indent)
                                        : leaf(in, items[i], ends, indent);
    if (!ends) out += smalls(in, 1, indent);
    if (odd(Odd::twice, 5)) out += once(in, items[i], indent);
  }
  return out;
}

std::string NestedSkill::wait_of(const Item& take) {
  return "WTM( " + std::string(take.answered ? "request " : "") + take.message + " from " + take.party + " )";
}

std::string NestedSkill::loop(const Module& in, const Item* main, Items items, const std::string& indent) {
  const std::string more = indent + "  ";
  std::string begins;
  std::string reply;
  if (main != nullptr && odd(Odd::gives_up, 1)) {
    // A round of its own is what it does when nothing comes.
    said_.emplace_back(in.name, wait_of(*main));
    const std::string answer =
        main->answered ? say(in, "TXM( " + main->message + " to " + main->party + " )", more + "  ") : "";
    const std::string obeys = tree(in, items, 1, false, more + "  ");
    return indent + "REPEAT\n" + more + wait_of(*main) + " WITHIN " + std::to_string(chance_.between(5, 60)) +
           " ms\n" + answer + obeys + work(in, more + "  ") + more + "ELSE\n" +
           (chance_(2) == 0 ? say(in, "SPC( c" + in.name + " )", more + "  ") : "") + small(in, more + "  ") +
           more + "END WTM\n" + indent + "UNTIL( forever )\n";
  }
  if (main != nullptr) {
    begins = say(in, wait_of(*main), more);
    if (main->answered) reply = say(in, "TXM( " + main->message + " to " + main->party + " )", more);
  } else if (chance_(2) == 0 && !items.empty() && items.front().kind == Item::Kind::call) {
    begins = once(in, items.front(), more);
    items.erase(items.begin());
  } else {
    begins = say(in, "p" + in.name, more);
  }
  std::string inside = tree(in, items, 3, false, more) + smalls(in, 2, more);
  inside += complete(in, more);
  if (chance_(2) == 0) inside = say(in, "RPC( c" + any_module() + " )", more) + inside;
  if (chance_(3) == 0) inside += say(in, "RPC( c" + any_module() + " )", more) + work(in, more);
  if (chance_(2) == 0) {
    const std::string set = say(in, "SPC( c" + in.name + " )", more);
    inside = chance_(2) == 0 ? set + inside : inside + set;
  }
  inside = chance_(3) == 0 ? begins + reply + inside : begins + inside + reply;
  if (in.name == "SM1" && odd(Odd::endings, 2)) return inside;
  if (!odd(Odd::endings, 3)) return indent + "REPEAT\n" + inside + indent + "UNTIL( forever )\n";
  return indent + "REPEAT\n" + inside + more + "SPC( c" + in.name + " )\n" + indent + "UNTIL( c" + in.name +
         " )\n";
}

std::string NestedSkill::before(const Module& in, const Item& take) {
  const std::string answer =
      take.answered ? "    TXM( " + take.message + " to " + take.party + " )\n" : work(in, "    ");
  if (chance_(2) == 0) {
    said_.emplace_back(in.name, wait_of(take));
    return "  " + wait_of(take) + " WITHIN " + std::to_string(chance_.between(0, 60)) + " ms\n" + answer +
           "  ELSE\n" + small(in, "    ") + "  END WTM\n";
  }
  return "  CONCURRENT\n  BEGIN\n    REPEAT\n" + say(in, wait_of(take), "    ") + answer +
         "    UNTIL( forever )\n  END\n  BEGIN\n" + say(in, "p" + in.name, "    ") +
         "  END\n  END CONCURRENT\n";
}

std::string NestedSkill::body(const Module& in) {
  std::string out = in.kind + ": " + in.name + "\n";
  for (int i = 1; i <= 3; ++i) out += "  ACTIVITY w" + std::to_string(i) + in.name + "\n";
  out += "  ACTIVITY p" + in.name + "\nBEGIN\n";
  if (in.name == "SM1") out += "  WTM( Coordinator )\n";
  Items takes;
  Items items;
  for (const Item& item : in.items) (item.kind == Item::Kind::take ? takes : items).push_back(item);
  if (odd(Odd::before, 2)) {
    out += items.empty() || chance_(2) == 0 ? small(in, "  ") : tree(in, {items.back()}, 2, false, "  ");
  }
  if (odd(Odd::commands, 1)) {
    // What it sends it sends once.
    const auto sends = [](const Item& item) { return item.kind == Item::Kind::send; };
    const auto first = std::stable_partition(items.begin(), items.end(), std::not_fn(sends));
    for (auto item = first; item != items.end(); ++item)
      out += (chance_(2) == 0 ? say(in, "p" + in.name, "  ") : "") + once(in, *item, "  ");
    items.erase(first, items.end());
  }
  chance_.shuffle(takes);
  if (!takes.empty() && odd(Odd::before, 2)) out += before(in, takes.front());
  if (odd(Odd::middle, 2)) {
    // All but one are taken in the middle of its rounds.
    while (takes.size() > 1) {
      items.push_back(takes.back());
      takes.pop_back();
    }
  }
  if (takes.size() < 2) {
    out += loop(in, takes.empty() ? nullptr : &takes.front(), items, "  ");
  } else {
    std::vector<Items> parts(takes.size());
    for (const Item& item : items)
      parts[static_cast<std::size_t>(chance_(static_cast<int>(takes.size())))].push_back(item);
    out += "  CONCURRENT\n";
    for (std::size_t i = 0; i < takes.size(); ++i) {
      out += "  BEGIN\n" + loop(in, &takes[i], parts[i], "    ") + "  END\n";
      blocks_.push_back(in.name + "." + std::to_string(i + 1));
    }
    out += "  END CONCURRENT\n";
  }
  if (in.name == "SM1") out += "  TXM( Completion Protocol 0 )\n";
  return out + "END\n";
}

}  // namespace pal::test
