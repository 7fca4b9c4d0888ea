// A skill as the dispatcher sees it, and a person who chooses one; whether a parameter may have a value.
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <string_view>

#include "pal/runtime/broken_promise.hpp"
#include "pal/runtime/in_use.hpp"
#include "pal/runtime/task.hpp"
#include "pal/runtime/wiring.hpp"

namespace pal::runtime {

enum class ParameterType { real, integer, boolean, text };

/// A number or a text that the starter of the skill may set; low <= default_value <= high, all in `unit`.
struct ParameterSpec {
  std::string_view name;
  ParameterType type = ParameterType::real;
  std::string_view unit;
  double low = 0;
  double high = 0;
  double default_value = 0;
  std::string_view description;
  std::string_view default_text = {};  // of a text, which has neither unit nor range
  bool location = false;               // a text: a name of a location that is taught
};

/// A way in which the skill can end.
struct CompletionSpec {
  enum class Kind { normal, contingency, error };
  int code = 0;
  Kind kind = Kind::normal;
  std::string_view description;
};

struct SkillDescription {
  std::string_view name;
  std::string_view environment;
  std::span<const std::string_view> descriptions;
  std::span<const ParameterSpec> parameters;
  std::span<const CompletionSpec> completions;
};

/// A parameter that does not exist, is out of its range, or is not of its type. what() says which, and which
/// values are allowed.
class ParameterError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws ParameterError unless `value` is allowed for `parameter`.
void check_parameter(const ParameterSpec& parameter, double value);
void check_parameter(const ParameterSpec& parameter, std::string_view text);

/// Throws the ParameterError for a name that the skill does not have.
[[noreturn]] void unknown_parameter(const SkillDescription& skill, std::string_view name);

/// Implemented by generated code.
class Skill {
 public:
  virtual ~Skill() = default;

  virtual const SkillDescription& description() const = 0;
  virtual const Wiring& wiring() const = 0;

  /// All parameters get their defaults.
  virtual void reset_parameters() = 0;
  /// `value` in the parameter's unit; booleans 0 or 1. Throws ParameterError.
  virtual void set_parameter(std::string_view name, double value) = 0;
  /// Of a parameter that is a TEXT. Throws ParameterError. This default always throws: it is for a skill
  /// without texts.
  virtual void set_text_parameter(std::string_view name, std::string_view text);

  /// The run begins: the modules forget their last run and their activities get the parameters.
  virtual void start() = 0;

  /// The coroutine of thread `index` of the wiring, not yet begun.
  virtual Task body(std::size_t index, Thread& thread) = 0;

  /// Fills the frame pool for modules that are run by Execute, before they are needed. It makes a coroutine
  /// for each such module and each thread that runs it. Then it drops all of them together.
  virtual void reserve_executed(Thread& thread) = 0;

  /// A promise was broken for the first time in this run, and the run's policy is `contingency`. True: the
  /// skill has an answer, which its own statements give. Called at the instant of the breach; in real time
  /// also while activities are at work.
  virtual bool promise_broken([[maybe_unused]] const BrokenPromise& broken) { return false; }

  /// Whether it runs; for the dispatcher.
  InUse& in_use() { return in_use_; }

 private:
  InUse in_use_;
};

}  // namespace pal::runtime
