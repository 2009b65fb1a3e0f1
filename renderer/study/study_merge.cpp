#include "renderer/study/study_merge.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/base/made_by.h"
#include "renderer/options/settings_json.h"
#include "renderer/study/journal.h"
#include "renderer/study/page/thumbnails.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

fs::path journal_of(const fs::path& folder) { return folder / "rows.jsonl"; }

// A shard that has measured nothing yet has no rows, or an empty journal.
std::vector<StudyRow> rows_in(const fs::path& folder) {
  std::error_code ignored;
  if (fs::file_size(journal_of(folder), ignored) == 0 || ignored) return {};
  return parse_journal(read_text_file(journal_of(folder)), journal_of(folder)).rows;
}

fs::file_time_type written(const fs::path& folder) {
  std::error_code ignored;
  const fs::file_time_type time = fs::last_write_time(journal_of(folder), ignored);
  return ignored ? fs::file_time_type::min() : time;
}

std::vector<fs::path> newest_first(std::vector<fs::path> folders) {
  std::stable_sort(folders.begin(), folders.end(),
                   [](const fs::path& a, const fs::path& b) { return written(a) > written(b); });
  return folders;
}

void must_be_same(const StudySpec& first, const fs::path& first_folder, const StudySpec& other,
                  const fs::path& folder) {
  if (first.name != other.name)
    throw Error(ExitCode::bad_input, folder.string(),
                fmt::format("holds the study '{}', and {} holds '{}'", other.name, first_folder.string(), first.name),
                "merge folders of one study");
  if (*first.json != *other.json)
    throw Error(ExitCode::bad_input, folder.string(),
                fmt::format("holds '{}' with other settings than {} does: spec.json differs", other.name,
                            first_folder.string()),
                "merge folders that were measured with the same command");
}

}  // namespace

void write_spec(const fs::path& folder, const StudySpec& spec) {
  write_text_file(folder / "spec.json", spec.json->dump(1) + "\n");
}

StudySpec read_spec_of(const fs::path& folder) {
  const fs::path file = folder / "spec.json";
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored))
    throw Error(ExitCode::bad_input, folder.string(), "holds no study: it has no spec.json",
                "give folders that `study -o` has written");
  return parse_study(read_text_file(file), file.string());
}

MergedRows merged_rows(const std::vector<fs::path>& folders) {
  MergedRows merged{read_spec_of(folders.front()), {}};
  for (const fs::path& folder : folders) must_be_same(merged.spec, folders.front(), read_spec_of(folder), folder);
  KeptRows kept(made_by());
  for (const fs::path& folder : newest_first(folders))
    for (StudyRow& row : rows_in(folder)) kept.take(std::move(row));
  merged.rows = kept.rows();
  return merged;
}

void merge_thumbnails(const std::vector<fs::path>& from, const fs::path& into, const std::vector<StudyRow>& rows) {
  const std::vector<fs::path> folders = newest_first(from);  // as their rows are taken
  for (const StudyRow& row : rows)
    for (const fs::path& folder : folders) {
      std::error_code ignored;
      if (fs::equivalent(folder, into, ignored)) continue;
      const Thumbnails found = read_thumbnails(folder, row.key);
      if (found.picture.empty() || found.error_map.empty()) continue;
      write_thumbnails(into, row.key, found);
      break;
    }
}

}  // namespace gbl
