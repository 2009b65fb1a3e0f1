#include "renderer/base/files.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <memory>
#include <mutex>
#include <new>
#include <poll.h>
#include <set>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "renderer/base/limits.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

struct Closer {
  void operator()(std::FILE* f) const { std::fclose(f); }
};
using File = std::unique_ptr<std::FILE, Closer>;

// It can only be asked by setting it: once, before other threads write files.
mode_t umask_of_program() {
  static const mode_t mask = [] {
    const mode_t m = ::umask(0);
    ::umask(m);
    return m;
  }();
  return mask;
}

// "final.png.gbufferlab-Ab3xYz"
constexpr std::string_view kMark = ".gbufferlab-", kRandom = "XXXXXX";

bool is_temporary(const std::string& name) {
  const size_t tail = kMark.size() + kRandom.size();
  return name.size() > tail && name.compare(name.size() - tail, kMark.size(), kMark) == 0;
}

// A file that is being written is locked: one that is not was left by a program that was killed. Where there are no
// locks all of them stay.
void remove_if_left(const fs::path& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0) return;
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
  ::close(file);
}

// Before the first file that this program writes into a folder.
void clear_once(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> cleared;
  std::error_code error;
  const fs::path whole = fs::absolute(folder, error);
  const std::lock_guard lock(mutex);
  if (!cleared.insert(whole).second) return;
  for (fs::directory_iterator entry(whole, error), end; !error && entry != end; entry.increment(error))
    if (is_temporary(entry->path().filename().string())) remove_if_left(entry->path());
}

// Makes it under a name that nobody else has, and locks it; -> its descriptor, below 0: errno says why not.
int make_locked(std::string& name) {
  const size_t random = name.size() - kRandom.size();
  while (true) {
    name.replace(random, kRandom.size(), kRandom);
    const int file = ::mkostemp(name.data(), O_CLOEXEC);
    struct stat facts {};
    if (file < 0) return file;
    if (::flock(file, LOCK_EX) != 0 || ::fstat(file, &facts) != 0 || facts.st_nlink > 0) return file;
    ::close(file);  // taken for one that was left, before it was locked
  }
}

// A new file beside the target, with the rights that a file made by fopen has.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target)
      : target_(target), name_(fmt::format("{}{}{}", target.string(), kMark, kRandom)) {
    clear_once(target.has_parent_path() ? target.parent_path() : ".");
    const int descriptor = make_locked(name_);
    if (descriptor < 0) throw CannotWrite(target_, std::strerror(errno));
    ::fchmod(descriptor, 0666 & ~umask_of_program());
    file_.reset(::fdopen(descriptor, "wb"));
  }
  ~TemporaryFile() {
    std::error_code ignored;
    if (!kept_) fs::remove(name_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;

  std::FILE* get() const { return file_.get(); }
  void keep() {
    if (std::fflush(get()) != 0 || std::ferror(get()) || ::fsync(::fileno(get())) != 0)
      throw CannotWrite(target_, std::strerror(errno));
    std::error_code error;
    fs::rename(name_, target_, error);  // while it is locked
    if (error) throw CannotWrite(target_, error.message());
    kept_ = true;
  }

 private:
  fs::path target_;
  std::string name_;
  File file_;
  bool kept_ = false;
};

}  // namespace

CannotWrite::CannotWrite(const fs::path& path, std::string_view why)
    : Error(ExitCode::unfinished, path.string(), fmt::format("cannot be written: {}", why),
            "choose a folder that can be written and has room") {}

namespace {

// To open a pipe waits for a writer: this waits for a while, and no longer.
File opened_to_read(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  File file(descriptor < 0 ? nullptr : ::fdopen(descriptor, "rb"));
  if (!file)
    throw Error(ExitCode::bad_input, path.string(), fmt::format("cannot be read: {}", std::strerror(errno)),
                "check the path");
  pollfd waiting{descriptor, POLLIN, 0};
  if (::poll(&waiting, 1, kPipeWaitMs) == 0)
    throw Error(ExitCode::bad_input, path.string(), "is a pipe into which nobody writes", "give a file");
  ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
  return file;
}

}  // namespace

void require_regular(const fs::path& path) {
  std::error_code none;
  const fs::file_status status = fs::status(path, none);
  if (!fs::exists(status) || fs::is_regular_file(status)) return;
  throw Error(ExitCode::bad_input, path.string(), fs::is_directory(status) ? "is a folder" : "is no file",
              "give a file that is kept on disk");
}

std::string read_text_file(const fs::path& path, size_t most) {
  const auto refuse = [&](const std::string& what, std::string_view fix) {
    return Error(ExitCode::bad_input, path.string(), what, fix);
  };
  const File file = opened_to_read(path);
  std::string text;
  char block[1 << 16];
  while (const size_t got = std::fread(block, 1, sizeof block, file.get())) {
    if (text.size() + got > most)
      throw refuse(fmt::format("is longer than {} MiB", most >> 20), "give a text file of this program's");
    text.append(block, got);
  }
  if (std::ferror(file.get())) throw refuse(fmt::format("cannot be read: {}", std::strerror(errno)), "check the path");
  if (text.empty()) throw refuse("is empty", "give a file with something in it");
  return text;
}

void require_plausible(const fs::path& path, size_t unpacked_bytes, size_t most_times) {
  std::error_code none;
  const auto bytes = static_cast<size_t>(fs::file_size(path, none));
  if (none || unpacked_bytes / most_times <= bytes) return;
  throw Error(ExitCode::bad_input, path.string(),
              fmt::format("claims {} bytes of pixels, more than its {} bytes can hold", unpacked_bytes, bytes),
              "it is cut short, or no picture");
}

void write_file(const fs::path& path, const std::function<void(std::FILE*)>& write) {
  TemporaryFile file(path);
  try {
    write(file.get());
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {  // of a library that encodes
    throw CannotWrite(path, std::ferror(file.get()) ? std::strerror(errno) : e.what());
  }
  file.keep();
}

void write_text_file(const fs::path& path, const std::string& text) {
  write_file(path, [&](std::FILE* file) { std::fwrite(text.data(), 1, text.size(), file); });
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) throw CannotWrite(folder, error ? error.message() : "it is not a folder");
}

void flush_output() {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return;
  throw Error(ExitCode::unfinished, "standard output", fmt::format("cannot be written: {}", std::strerror(errno)),
              "make room, or send it elsewhere");
}

}  // namespace gbl
