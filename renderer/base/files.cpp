#include "renderer/base/files.h"

#include <cerrno>
#include <cstring>
#include <fmt/format.h>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

#include "renderer/base/error.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const fs::path& path, const std::string& why) {
  throw Error(ExitCode::unfinished, path.string(), fmt::format("cannot be written: {}", why),
              "choose a folder that can be written and has room");
}

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

// A new file beside the target, with the rights that a file made by fopen has.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target) : target_(target), name_(target.string() + ".XXXXXX") {
    const int descriptor = ::mkstemp(name_.data());
    if (descriptor < 0) cannot_write(target_, std::strerror(errno));
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
    const bool whole = std::fflush(get()) == 0 && !std::ferror(get()) && ::fsync(::fileno(get())) == 0;
    const int why = errno;
    if (std::fclose(file_.release()) != 0 || !whole) cannot_write(target_, std::strerror(whole ? errno : why));
    std::error_code error;
    fs::rename(name_, target_, error);
    if (error) cannot_write(target_, error.message());
    kept_ = true;
  }

 private:
  fs::path target_;
  std::string name_;
  File file_;
  bool kept_ = false;
};

}  // namespace

std::string read_text_file(const fs::path& path, size_t most) {
  const auto refuse = [&](const std::string& what, std::string_view fix) {
    return Error(ExitCode::bad_input, path.string(), what, fix);
  };
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) throw refuse(fmt::format("cannot be read: {}", std::strerror(errno)), "check the path");
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
  } catch (const std::runtime_error& e) {  // of a library that encodes
    cannot_write(path, e.what());
  }
  file.keep();
}

void write_text_file(const fs::path& path, const std::string& text) {
  write_file(path, [&](std::FILE* file) { std::fwrite(text.data(), 1, text.size(), file); });
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) cannot_write(folder, error ? error.message() : "it is not a folder");
}

void flush_output() {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return;
  throw Error(ExitCode::unfinished, "standard output", fmt::format("cannot be written: {}", std::strerror(errno)),
              "make room, or send it elsewhere");
}

}  // namespace gbl
