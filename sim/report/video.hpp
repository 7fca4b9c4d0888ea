// A video of a run, drawn and encoded beside it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/picture/picture.hpp"
#include "sim/workcell.hpp"

namespace pal::sim {

/// 25 pictures a second of simulated time.
inline constexpr runtime::Time video_period = std::chrono::milliseconds(40);

struct VideoOptions {
  std::string file;  // MP4
  /// Width and height must be even.
  PictureOptions picture{.width = 960, .height = 540, .quality = Quality::quick};
  std::string encoder = "ffmpeg";  // a name that is looked up in PATH, or a path
};

/// There can be no video: why, and what to do about it.
class VideoError : public std::runtime_error {
 public:
  VideoError(const std::string& cause, std::string hint)
      : std::runtime_error(cause), hint_(std::move(hint)) {}
  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// Copies the workcell's state at each picture; a thread of its own draws the pictures and passes them to
/// ffmpeg. The same run gives the same file, byte for byte, on one machine.
class Video {
 public:
  /// Starts the thread and ffmpeg, and makes the file's folder if it is missing. Throws VideoError.
  Video(Workcell& workcell, const VideoOptions& options);
  /// Without finish(): drops what was filmed.
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// The workcell as it stands becomes the next picture. Takes microseconds, unless 3000 pictures (two
  /// minutes) wait to be drawn: then it waits for one.
  void film();

  /// Draws what is left and ends the file, which is then there as a whole or not at all. Throws VideoError.
  void finish();

 private:
  class Studio;
  void remember(const Sample& sample);

  Workcell& workcell_;
  std::unique_ptr<Studio> studio_;
  std::vector<HistoryPoint> seen_;  // since the last picture
  std::shared_ptr<void> samples_;
};

}  // namespace pal::sim
