#pragma once
// rows.jsonl: what a study has measured so far, a row a line. Whatever happens, what is in it are whole rows: they are
// appended as they finish, skipped when the study is run again, and journals of several machines may be concatenated.
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/study/rows/study_row.h"

namespace gbl {

class Journal {
 public:
  // Opens or makes the file and reads its rows. A torn last line is dropped from the file. Error(bad_input) with its
  // line for a bad one elsewhere; Error(unfinished) if the file cannot be written or another study writes to it.
  // made_by: what another program has measured does not count; empty: all rows do.
  explicit Journal(std::filesystem::path, std::string made_by = {});
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // The row of this key, if this program has measured it; else null. One that failed is not measured: it is tried again.
  const StudyRow* found(std::string_view key) const;
  bool has(std::string_view key) const { return found(key) != nullptr; }
  const std::string& made_by() const { return made_by_; }
  // One whole line, on the disk when this returns.
  // Error(unfinished) if it cannot be kept, and then nothing of it is; also if the file has been deleted or replaced.
  void append(const StudyRow& row);
  // One row per key, in the order in which the keys first came: the first that this program
  // measured, else the first of another, else the last that failed.
  const std::vector<StudyRow>& rows() const { return rows_; }

 private:
  void read();
  void take(StudyRow row);
  bool counts(const StudyRow& row) const { return !row.failed && (made_by_.empty() || row.made_by == made_by_); }

  std::filesystem::path path_;
  std::string made_by_;
  int file_ = -1;
  std::vector<StudyRow> rows_;
  std::map<std::string, size_t, std::less<>> by_key_;
};

}  // namespace gbl
