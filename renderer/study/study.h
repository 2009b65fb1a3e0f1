#pragma once
// Running a study: case by case, what is done before is skipped, what fails is a row with its reason. A row is a claim
// about speed and accuracy; neither is measured here without the other: both come from the one RowFn.
#include <atomic>
#include <functional>
#include <optional>
#include <string_view>

#include "renderer/study/journal.h"
#include "renderer/study/study_spec.h"

namespace gbl {

// Of n machines the i-th, from 1: every n-th case.
struct Shard {
  size_t index = 1, of = 1;
  bool takes(size_t case_index) const { return case_index % of == index - 1; }
};
Shard parse_shard(std::string_view);  // "2/3"; Error(bad_input) says what is wrong

struct StudyProgress {
  size_t done = 0, total = 0;          // of this shard; done: measured now or before, or failed now
  size_t failed = 0;                   // now
  std::optional<double> seconds_left;  // empty until a row has been measured; not more than what is left of the budget
  const StudyCase* next = nullptr;     // about to be measured; null at the end
};

struct StudyCounts {
  size_t measured = 0, failed = 0;  // now
  size_t before = 0;                // found in the journal
  size_t left = 0;                  // not come to: it was cancelled, or its time was up
};

// Measures a case. What it throws is the row's reason to have failed; with
// ExitCode::interrupted the study stops there instead.
using RowFn = std::function<MeasuredColumns(const StudyCase&)>;
using ProgressFn = std::function<void(const StudyProgress&)>;  // before each case and at the end

// A row of a case: where it stands in its study, then its columns or why there are none.
StudyRow measured_row(const std::string& study, const StudyCase&, MeasuredColumns);
StudyRow failed_row(const std::string& study, const StudyCase&, const std::string& reason);

// Stops between two rows when `cancel` is set and when it has run for so many seconds. Errors of the journal are thrown on: a row that cannot be kept need not
// be measured.
StudyCounts run_study(const StudyPlan&, Shard, Journal&, const RowFn&, const ProgressFn&,
                      const std::atomic<bool>& cancel, std::optional<double> budget_s = {});

}  // namespace gbl
