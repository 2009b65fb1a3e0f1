#include "renderer/study/journal.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <optional>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "renderer/base/error.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

[[noreturn]] void cannot_write(const std::filesystem::path& path, int error) {
  throw Error(ExitCode::unfinished, path.string(), fmt::format("cannot be written: {}", std::strerror(error)),
              "make room or choose another folder, then run the study again: rows that are done are kept");
}

// Fowler, Noll and Vo: FNV-1a, 64 bits.
uint64_t fnv1a(std::string_view text) {
  uint64_t hash = 0xcbf29ce484222325ull;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  return hash;
}

bool failed(const Json& row) { return row.contains("failed"); }

// A row is an object with a key.
std::optional<Json> parse_row(std::string_view line) {
  Json row = Json::parse(line, nullptr, false);
  const bool good = row.is_object() && row.contains("key") && row["key"].is_string();
  return good ? std::optional(std::move(row)) : std::nullopt;
}

int open_to_append(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_APPEND | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
  struct stat facts {};
  if (file < 0 || ::fstat(file, &facts) != 0) cannot_write(path, errno);
  if (!S_ISREG(facts.st_mode)) {
    ::close(file);
    throw Error(ExitCode::bad_input, path.string(), "is not a file", "choose another folder");
  }
  // Some network file systems know no locks: only a lock that is held is a reason to stop.
  if (::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(file);
    throw Error(ExitCode::unfinished, path.string(), "another study writes to it",
                "wait for it, or give each its own folder and concatenate the files");
  }
  return file;
}

}  // namespace

std::string row_key(const Settings& s) {
  Json json = to_json(s);
  json.erase("view");
  return fmt::format("{:016x}", fnv1a(json.dump()));
}

Journal::Journal(std::filesystem::path path) : path_(std::move(path)), file_(open_to_append(path_)) {
  try {
    read();
  } catch (...) {
    ::close(file_);
    throw;
  }
}

Journal::~Journal() { ::close(file_); }

void Journal::read() {
  std::ifstream file(path_, std::ios::binary);
  std::stringstream text;
  if (!file || (file.peek() != std::ifstream::traits_type::eof() && !(text << file.rdbuf())))
    throw Error(ExitCode::bad_input, path_.string(), "cannot be read", "check its permissions");
  const std::string all = text.str();
  size_t line = 1;
  for (size_t begin = 0; begin < all.size(); ++line) {
    const size_t end = all.find('\n', begin);
    const bool whole = end != std::string::npos, last = !whole || end + 1 == all.size();
    auto row = whole ? parse_row(std::string_view(all).substr(begin, end - begin)) : std::nullopt;
    if (!row && !last)
      throw Error(ExitCode::bad_input, fmt::format("{}:{}", path_.string(), line), "is not a row of a study",
                  "delete this line: its case is measured again");
    if (!row) {
      if (::ftruncate(file_, static_cast<off_t>(begin)) != 0) cannot_write(path_, errno);
      return;
    }
    take(std::move(*row));
    begin = end + 1;
  }
}

void Journal::take(Json row) {
  const auto [it, is_new] = by_key_.emplace(row["key"].get<std::string>(), rows_.size());
  if (is_new)
    rows_.push_back(std::move(row));
  else if (failed(rows_[it->second]))
    rows_[it->second] = std::move(row);
}

bool Journal::has(std::string_view key) const {
  const auto it = by_key_.find(key);
  return it != by_key_.end() && !failed(rows_[it->second]);
}

void Journal::append(const Json& row) {
  const std::string line = row.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
  struct stat before {};
  if (::fstat(file_, &before) != 0) cannot_write(path_, errno);
  errno = 0;
  const ssize_t written = ::write(file_, line.data(), line.size());
  const bool kept = written == static_cast<ssize_t>(line.size()) && ::fsync(file_) == 0;
  if (!kept) {
    const int error = errno != 0 ? errno : ENOSPC;  // a short write says nothing: there was no room for the rest
    // If even this fails, what is left is a torn last line, and the next reader drops it.
    static_cast<void>(::ftruncate(file_, before.st_size) + 0);
    cannot_write(path_, error);
  }
  take(Json::parse(line));
}

}  // namespace gbl
