#include "sim/report/video.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/unit/sim/support.hpp"

using namespace pal::sim;
using namespace pal::sim::test;

namespace fs = std::filesystem;

namespace {

class VideoFolder {
 public:
  VideoFolder() : path_(fs::temp_directory_path() / ("pal-video-" + std::to_string(::getpid()))) {}
  ~VideoFolder() { fs::remove_all(path_); }
  VideoFolder(const VideoFolder&) = delete;
  VideoFolder& operator=(const VideoFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::size_t count() const {
    return fs::exists(path_) ? static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), {})) : 0;
  }

 private:
  fs::path path_;
};

std::string content(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

VideoOptions small(const std::string& file) {
  VideoOptions options{.file = file};
  options.picture.width = 320;
  options.picture.height = 180;
  return options;
}

/// The joints at the end: filming must not change them.
Joints film(const VideoOptions& options, bool finish = true) {
  Workcell workcell(scene("touch"));
  Video video(workcell, options);
  workcell.move({.dz = 0.5}, CorrectionFrame::tool, 28ms);
  for (int i = 0; i < 6; ++i) {
    workcell.advance_to(i * video_period);
    video.film();
  }
  if (finish) video.finish();
  return workcell.joints();
}

bool possible() {
  const VideoFolder folder;
  try {
    film(small(folder.file("try.mp4")));
    return true;
  } catch (const VideoError& problem) {
    WARN("no video here: " << problem.what());
    return false;
  }
}

}  // namespace

TEST_CASE("a video repeats byte for byte, and is whole or not there") {
  if (!possible()) return;
  const VideoFolder folder;
  const Joints first = film(small(folder.file("a.mp4")));
  CHECK(film(small(folder.file("b.mp4"))) == first);
  const std::string bytes = content(folder.file("a.mp4"));
  CHECK(bytes.substr(4, 4) == "ftyp");
  CHECK(bytes.find("moov") < bytes.find("mdat"));  // a browser can begin before all is there
  CHECK(bytes == content(folder.file("b.mp4")));
  film(small(folder.file("c.mp4")), false);  // dropped
  CHECK(folder.count() == 2);

  Workcell unseen(scene("touch"));
  unseen.move({.dz = 0.5}, CorrectionFrame::tool, 28ms);
  unseen.advance_to(5 * video_period);
  CHECK(unseen.joints() == first);
}

TEST_CASE("a video that cannot be made says why, and leaves nothing") {
  const VideoFolder folder;
  VideoOptions options = small(folder.file("a.mp4"));
  options.encoder = "ffmpeg-that-is-not-there";
  CHECK_THROWS_WITH(film(options), "ffmpeg-that-is-not-there is not installed, and a video needs it");
  CHECK(folder.count() == 0);
  if (!possible()) return;
  // It ends before it has read anything, or while it is being written to.
  options.encoder = "/bin/false";
  CHECK_THROWS_WITH(film(options), Catch::Contains("a.mp4 cannot be written: false ended with status 1"));
  CHECK(folder.count() == 0);
  options = small("/proc/none/a.mp4");
  CHECK_THROWS_AS(film(options), VideoError);
}
