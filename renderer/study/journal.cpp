#include "renderer/study/journal.h"

#include <algorithm>
#include <cerrno>
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
#include "renderer/study/row_json.h"

namespace gbl {
namespace {

[[noreturn]] void cannot_write(const std::filesystem::path& path, int error) {
  throw Error(ExitCode::unfinished, path.string(), fmt::format("cannot be written: {}", std::strerror(error)),
              "make room or choose another folder, then run the study again: rows that are done are kept");
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

JournalLines parse_journal(std::string_view text, const std::filesystem::path& path) {
  JournalLines out;
  size_t line = 1;
  for (size_t begin = 0; begin < text.size(); ++line) {
    const size_t end = text.find('\n', begin);
    const bool whole = end != std::string_view::npos, last = !whole || end + 1 == text.size();
    const std::string where = fmt::format("{}:{}", path.string(), line);
    auto row = whole ? parse_journal_line(text.substr(begin, end - begin), where) : std::nullopt;
    if (!row && !last)
      throw Error(ExitCode::bad_input, where, "is not a row of a study",
                  "delete this line: its case is measured again");
    if (!row) return out;
    out.rows.push_back(std::move(*row));
    out.whole_bytes = begin = end + 1;
  }
  return out;
}

void KeptRows::take(StudyRow row) {
  const auto [it, is_new] = by_key_.emplace(row.key, rows_.size());
  if (is_new)
    rows_.push_back(std::move(row));
  else if (StudyRow& known = rows_[it->second]; known.failed || (!counts(known) && counts(row)))
    known = std::move(row);
}

const StudyRow* KeptRows::found(std::string_view key) const {
  const auto it = by_key_.find(key);
  return it != by_key_.end() && counts(rows_[it->second]) ? &rows_[it->second] : nullptr;
}

Journal::Journal(std::filesystem::path path, std::string made_by)
    : path_(std::move(path)), file_(open_to_append(path_)), kept_(std::move(made_by)) {
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
  JournalLines lines = parse_journal(all, path_);
  if (lines.whole_bytes < all.size() && ::ftruncate(file_, static_cast<off_t>(lines.whole_bytes)) != 0)
    cannot_write(path_, errno);
  for (StudyRow& row : lines.rows) kept_.take(std::move(row));
}

void Journal::append(const StudyRow& row) {
  const std::string line = journal_line(row);
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
  struct stat named {};
  if (::stat(path_.c_str(), &named) != 0 || named.st_ino != before.st_ino || named.st_dev != before.st_dev)
    throw Error(ExitCode::unfinished, path_.string(), "was deleted or replaced while the study ran",
                "run the study again: what had been measured went with the file");
  kept_.take(*parse_journal_line(line, path_.string()));  // as the next run will find it
}

}  // namespace gbl
