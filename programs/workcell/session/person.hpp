// Who answers the questions of an operation.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "operations/executor.hpp"

namespace pal::workcell {

class Person {
 public:
  virtual ~Person() = default;
  /// As the functions of operations::SkillRunner.
  virtual void ask(const operations::Question& question) = 0;
  virtual operations::Reply answer() = 0;
  virtual void withdraw() {}
};

/// Answers that were given before it runs, each once and in their order; then those of a person who reads
/// `out` and writes lines.
class PersonAtTerminal final : public Person {
 public:
  /// `prepared`: "ICON=ANSWER". `in` may be null: nobody writes. Both outlive the person. Throws Failure.
  PersonAtTerminal(const std::vector<std::string>& prepared, std::istream* in, std::ostream& out);

  void ask(const operations::Question& question) override;
  operations::Reply answer() override;

 private:
  struct Prepared {
    std::string icon, answer;
    bool used = false;
  };
  std::vector<Prepared> prepared_;
  std::istream* in_;
  std::ostream& out_;
  operations::Question question_;
};

}  // namespace pal::workcell
