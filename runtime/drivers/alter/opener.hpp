// How ALTER is opened and closed: by other means than its own line.
#pragma once

#include <functional>
#include <string>

namespace pal::runtime::drivers::alter {

/// How corrections are meant.
struct Mode {
  bool world = false;      // in frame 0; otherwise in the tool's frame
  bool cumulative = true;  // they add up; otherwise each counts from where ALTER was opened
  bool joints = false;     // of the joints, in degrees each, whatever `world` says; they always add up

  friend bool operator==(const Mode&, const Mode&) = default;
};

/// On the real machine a VAL program does it (DO ALTER, DO NOALTER on the terminal line).
class Opener {
 public:
  virtual ~Opener() = default;

  /// Is called once, at once or later. Empty: it is done; otherwise why it cannot be.
  using Done = std::function<void(std::string problem)>;
  virtual void open(const Mode& mode, Done done) = 0;
  virtual void close(Done done) = 0;
};

}  // namespace pal::runtime::drivers::alter
