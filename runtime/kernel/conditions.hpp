// The process conditions of a run.
#pragma once

#include <vector>

#include "runtime/kernel/journal.hpp"

namespace pal::runtime {

class Conditions {
 public:
  Conditions(Journal& journal, std::size_t count) : journal_(journal), values_(count, false) {}

  void set(const Thread& thread, int condition, bool value) {
    values_[static_cast<std::size_t>(condition)] = value;
    journal_.record(trace::Kind::set, thread, condition, value ? 1 : 0);
  }
  bool read(const Thread& thread, int condition) {
    const bool value = values_[static_cast<std::size_t>(condition)];
    journal_.record(trace::Kind::read, thread, condition, value ? 1 : 0);
    return value;
  }

 private:
  Journal& journal_;
  std::vector<bool> values_;
};

}  // namespace pal::runtime
