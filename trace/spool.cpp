#include "pal/trace/spool.hpp"

#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace pal::trace {

namespace {

int temporary_file() {
  std::string name = (std::filesystem::temp_directory_path() / "pal-run-XXXXXX").string();
  const int file = ::mkstemp(name.data());
  if (file < 0) throw std::runtime_error("no temporary file can be made: " + name);
  ::unlink(name.c_str());
  return file;
}

int file_in_memory() {
  const int file = ::memfd_create("pal-run", MFD_CLOEXEC);
  if (file < 0) throw std::runtime_error("no file can be made in memory");
  return file;
}

}  // namespace

SpoolFile::SpoolFile(SpoolPlace place) {
  const int file = place == SpoolPlace::memory ? file_in_memory() : temporary_file();
  file_.reset(::fdopen(file, "w+b"));
  if (!file_) throw std::runtime_error("no temporary file can be opened");
  // Without room of its own the C library takes 4096 bytes, whatever size is asked for.
  room_.resize(1U << 16U);
  std::setvbuf(file_.get(), room_.data(), _IOFBF, room_.size());
}

bool SpoolFile::append(const void* bytes, std::size_t count) noexcept {
  if (!failed_ && std::fwrite(bytes, 1, count, file_.get()) != count) failed_ = true;
  return !failed_;
}

std::size_t SpoolFile::read(std::size_t offset, void* room, std::size_t count) const {
  std::fflush(file_.get());
  std::size_t got = 0;
  while (got < count) {
    const ssize_t part = ::pread(::fileno(file_.get()), static_cast<char*>(room) + got, count - got,
                                 static_cast<off_t>(offset + got));
    if (part <= 0) break;
    got += static_cast<std::size_t>(part);
  }
  return got;
}

EventSource events_of(const Trace& trace) {
  return [&trace](const std::function<void(const Event&)>& see) {
    for (const Event& event : trace.events) see(event);
  };
}

EventSource events_of(const EventSpool& spool) {
  return [&spool](const std::function<void(const Event&)>& see) { spool.for_each(see); };
}

}  // namespace pal::trace
