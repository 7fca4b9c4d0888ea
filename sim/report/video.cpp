#include "sim/report/video.hpp"

#include <unistd.h>

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <future>
#include <mutex>
#include <thread>

#include "sim/picture/sheet.hpp"
#include "sim/report/process.hpp"

namespace pal::sim {
namespace {

constexpr std::size_t most_waiting = 3000;
constexpr double calm = 0.9;  // the camera makes most of its way within a second

// One thread and no time stamps or versions: the same pictures give the same bytes.
std::vector<std::string> encoder_arguments(const VideoOptions& options, const std::string& file) {
  const std::string size =
      std::to_string(options.picture.width) + "x" + std::to_string(options.picture.height);
  return {"-loglevel",
          "error",
          "-f",
          "rawvideo",
          "-pixel_format",
          "rgb24",
          "-video_size",
          size,
          "-framerate",
          "25",
          "-threads",
          "1",
          "-i",
          "pipe:0",
          "-filter_threads",
          "1",
          "-vf",
          "scale=out_color_matrix=bt709:out_range=tv:flags=bitexact+accurate_rnd",
          "-c:v",
          "libx264",
          "-preset",
          "fast",
          "-crf",
          "20",
          "-pix_fmt",
          "yuv420p",
          "-colorspace",
          "bt709",
          "-color_primaries",
          "bt709",
          "-color_trc",
          "bt709",
          "-threads",
          "1",
          "-fflags",
          "+bitexact",
          "-flags:v",
          "+bitexact",
          "-movflags",
          "+faststart",
          "-f",
          "mp4",
          "-y",
          file};
}

std::unique_ptr<Process> start_encoder(const VideoOptions& options, const std::string& file) {
  const auto program = find_program(options.encoder);
  if (!program)
    throw VideoError(options.encoder + " is not installed, and a video needs it", "apt-get install ffmpeg");
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::error_code problem;
  if (!folder.empty()) std::filesystem::create_directories(folder, problem);
  if (problem) throw VideoError(folder.string() + ": " + problem.message(), "choose another folder");
  try {
    return std::make_unique<Process>(*program, encoder_arguments(options, file));
  } catch (const std::runtime_error& failed) {
    throw VideoError(failed.what(), "look whether there is memory for another program");
  }
}

}  // namespace

// The thread, its queue, and what it draws with.
class Video::Studio {
 public:
  Studio(const mjModel& model, const VideoOptions& options)
      : part_(options.file + "." + std::to_string(::getpid()) + ".part"),
        file_(options.file),
        encoder_(start_encoder(options, part_)),
        thread_([this, &model, options] { work(model, options); }) {
    // The model is read before this returns: afterwards the run may change it.
    if (const auto problem = begun_.get_future().get()) {
      thread_.join();
      encoder_.reset();
      drop_file();
      throw VideoError(*problem);
    }
  }

  ~Studio() {
    if (!thread_.joinable()) return;
    {
      const std::lock_guard lock(mutex_);
      waiting_.clear();
      stopped_ = true;
    }
    changed_.notify_all();
    thread_.join();
    encoder_->wait();
    drop_file();
  }
  Studio(const Studio&) = delete;
  Studio& operator=(const Studio&) = delete;

  void add(Snapshot snapshot) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return waiting_.size() < most_waiting || problem_; });
    if (problem_) return;  // finish() says so: a run is worth more than its video
    waiting_.push_back(std::move(snapshot));
    changed_.notify_all();
  }

  void finish() {
    {
      const std::lock_guard lock(mutex_);
      stopped_ = true;
    }
    changed_.notify_all();
    thread_.join();
    if (const auto said = encoder_->wait()) problem_ = said;
    std::error_code renamed;
    if (!problem_) std::filesystem::rename(part_, file_, renamed);
    if (renamed) problem_ = renamed.message();
    if (!problem_) return;
    drop_file();
    throw VideoError(file_ + " cannot be written: " + *problem_,
                     "look whether there is room, and whether ffmpeg has libx264 (ffmpeg -encoders)");
  }

 private:
  void work(const mjModel& model, const VideoOptions& options) {
    std::optional<Sheet> sheet;
    try {
      sheet.emplace(model, options.picture);
    } catch (const NoOffscreen& problem) {
      begun_.set_value(VideoError(problem.what(), problem.packages().empty()
                                                      ? "run without --video"
                                                      : "apt-get install " + problem.packages()));
      return;
    } catch (const std::exception& problem) {
      begun_.set_value(VideoError(problem.what(), "run without --video"));
      return;
    }
    begun_.set_value(std::nullopt);
    try {
      while (const auto snapshot = take()) {
        if (!encoder_->write(sheet->draw(*snapshot, calm).pixels))
          throw std::runtime_error("ffmpeg has ended");
      }
    } catch (const std::exception& problem) {
      const std::lock_guard lock(mutex_);
      problem_ = problem.what();
      changed_.notify_all();
    }
  }

  /// The next picture to draw; nothing: there will be no more.
  std::optional<Snapshot> take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stopped_ || !waiting_.empty(); });
    if (waiting_.empty()) return std::nullopt;
    Snapshot snapshot = std::move(waiting_.front());
    waiting_.pop_front();
    changed_.notify_all();
    return snapshot;
  }

  void drop_file() {
    std::error_code ignored;
    std::filesystem::remove(part_, ignored);
  }

  std::string part_, file_;
  std::unique_ptr<Process> encoder_;
  std::promise<std::optional<VideoError>> begun_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Snapshot> waiting_;
  std::optional<std::string> problem_;
  bool stopped_ = false;
  std::thread thread_;  // last: it uses all the rest
};

Video::Video(Workcell& workcell, const VideoOptions& options)
    : workcell_(workcell),
      studio_(std::make_unique<Studio>(workcell.physics().model(), options)),
      samples_(workcell.on_sample([this](const Sample& sample) { remember(sample); })) {}

Video::~Video() = default;

void Video::remember(const Sample& sample) {
  if (workcell_.tool_kind() == ToolKind::range_finder) return;  // each picture measures the distance itself
  seen_.emplace_back(std::chrono::duration<double>(sample.time).count(),
                     shown_force(workcell_.tool_kind(), sample));
}

void Video::film() {
  studio_->add(take_snapshot(workcell_, std::exchange(seen_, {})));
}

void Video::finish() {
  studio_->finish();
}

}  // namespace pal::sim
