// What a skill is required to keep, as docs/reference/execution-model.md measures it.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "pal/pan/environment.hpp"
#include "pal/pan/network.hpp"

namespace pal::test {

/// One thing that is measured.
struct Wanted {
  enum class Kind {
    age,
    sample_age,
    reaction,
    sample_reaction,
    response,
    least,
    greatest,
    loss,
    duration,
    busy,
    load
  };
  std::string name;
  Kind kind = Kind::age;
  std::set<std::pair<int, int>> at;  // module, node
  int condition = -1;                // age, reaction
  std::set<int> samples;             // sample_age, sample_reaction: channels
  std::set<int> events;              // response: channels
  std::string device;                // loss
  int in = 1;                        // loss
  int code = 0;                      // duration
  std::vector<int> processors;       // busy, load
  // What counts comes after one of these is done first, or while a thread is in one of these loops.
  std::set<std::pair<int, int>> after;                  // module, node
  std::set<std::pair<int, std::pair<int, int>>> loops;  // module, nodes of REPEAT and UNTIL

  bool limited() const { return !after.empty() || !loops.empty(); }

  bool of_condition() const { return kind == Kind::age || kind == Kind::reaction; }
  bool of_samples() const { return kind == Kind::sample_age || kind == Kind::sample_reaction; }
  bool of_interval() const { return kind == Kind::least || kind == Kind::greatest; }
};

/// What `network` requires, and what the devices of `environment` add.
std::vector<Wanted> wanted(const pan::Network& network, const pan::Environment& environment);

/// Of a device, or of a module without a body, which stands for one.
std::string party_name(const pan::Network& network, const pan::Party& party);

}  // namespace pal::test
