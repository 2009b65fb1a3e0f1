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

// One row per key, in the order in which the keys first came: the first that this program measured, else the first of
// another, else the last that failed.
class KeptRows {
 public:
  // made_by: what another program has measured does not count; empty: all rows do.
  explicit KeptRows(std::string made_by) : made_by_(std::move(made_by)) {}
  void take(StudyRow);
  // The row of this key, if this program has measured it; else null. One that failed is not measured.
  const StudyRow* found(std::string_view key) const;
  const std::vector<StudyRow>& rows() const { return rows_; }
  const std::string& made_by() const { return made_by_; }

 private:
  bool counts(const StudyRow& row) const { return !row.failed && (made_by_.empty() || row.made_by == made_by_); }
  std::string made_by_;
  std::vector<StudyRow> rows_;
  std::map<std::string, size_t, std::less<>> by_key_;
};

// The lines of a journal; a torn last one is no row. Error(bad_input) with its line for a bad one elsewhere.
struct JournalLines {
  std::vector<StudyRow> rows;
  size_t whole_bytes = 0;  // of the text, up to a torn line
};
JournalLines parse_journal(std::string_view text, const std::filesystem::path&);

class Journal {
 public:
  // Opens or makes the file and reads its rows. A torn last line is dropped from the file. Errors are those of
  // parse_journal(), and Error(unfinished) if the file cannot be written or another study writes to it.
  explicit Journal(std::filesystem::path, std::string made_by = {});
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // As KeptRows has it: one that failed is tried again.
  const StudyRow* found(std::string_view key) const { return kept_.found(key); }
  bool has(std::string_view key) const { return found(key) != nullptr; }
  const std::string& made_by() const { return kept_.made_by(); }
  // One whole line, on the disk when this returns.
  // Error(unfinished) if it cannot be kept, and then nothing of it is; also if the file has been deleted or replaced.
  void append(const StudyRow& row);
  const std::vector<StudyRow>& rows() const { return kept_.rows(); }

 private:
  void read();

  std::filesystem::path path_;
  int file_ = -1;
  KeptRows kept_;
};

}  // namespace gbl
