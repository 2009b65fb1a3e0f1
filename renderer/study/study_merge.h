#pragma once
// Folders of one study that were measured apart, by shards or on several machines, as one.
#include <filesystem>

#include "renderer/study/rows/study_row.h"
#include "renderer/study/study_spec.h"

namespace gbl {

// spec.json: the study of this folder, as it was asked for. It can be run again as a study by itself.
void write_spec(const std::filesystem::path& folder, const StudySpec&);
StudySpec read_spec_of(const std::filesystem::path& folder);  // Error(bad_input): the folder holds no study

struct MergedRows {
  StudySpec spec;
  std::vector<StudyRow> rows;
};
// A row of a key that several have: one that was measured goes before one that failed, one of this program before one of
// another, and then the one of the folder whose journal was written last. Error(bad_input): a folder holds no study, or
// not the same one as the first.
MergedRows merged_rows(const std::vector<std::filesystem::path>& folders);

// The thumbnails of these rows, from the newest folder that has them.
void merge_thumbnails(const std::vector<std::filesystem::path>& from, const std::filesystem::path& into,
                      const std::vector<StudyRow>&);

}  // namespace gbl
