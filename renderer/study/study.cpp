#include "renderer/study/study.h"

#include <chrono>
#include <cmath>
#include <fmt/format.h>

#include "renderer/base/files.h"
#include "renderer/base/made_by.h"
#include "renderer/base/number.h"
#include "renderer/study/row_json.h"

namespace gbl {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

struct Todo {
  const StudyCase* study_case;
  std::string key;
};

// Empty: the study is to stop. What cannot be written ends it: the next row would be lost, too.
std::optional<StudyRow> measured(const StudyPlan& plan, const Todo& todo, const RowFn& measure) {
  std::string reason;
  try {
    return measured_row(plan.study, *todo.study_case, measure(*todo.study_case));
  } catch (const CannotWrite&) {
    throw;
  } catch (const Error& e) {
    if (e.code() == ExitCode::interrupted) return {};
    reason = e.what();
  } catch (const std::exception& e) {  // no memory for this one's targets: smaller ones may follow
    reason = e.what();
  }
  return failed_row(plan.study, *todo.study_case, reason);
}

}  // namespace

StudyRow measured_row(const std::string& study, const StudyCase& c, MeasuredColumns m) {
  return {study, c.id, row_key(c.settings), c.at, {}, std::move(m.cells), std::move(m.drawn), made_by()};
}

StudyRow failed_row(const std::string& study, const StudyCase& c, const std::string& reason) {
  return {study, c.id, row_key(c.settings), c.at, reason, {}, c.settings, made_by()};
}

Shard parse_shard(std::string_view text) {
  const auto bad = [&](std::string_view what) {
    return Error(ExitCode::bad_input, "--shard", fmt::format("'{}' {}", text, what), "write i/n, e.g. 2/3");
  };
  const size_t slash = text.find('/');
  if (slash == std::string_view::npos) throw bad("is not a shard");
  const auto index = whole_decimal(text.substr(0, slash)), of = whole_decimal(text.substr(slash + 1));
  if (!index || !of || *index < 0 || *of < 0) throw bad("is not a shard");
  const Shard shard{static_cast<size_t>(*index), static_cast<size_t>(*of)};
  if (shard.index < 1) throw bad("counts from 0, and shards count from 1");
  if (shard.index > shard.of) throw bad("is beyond the last shard");
  return shard;
}

StudyCounts run_study(const StudyPlan& plan, Shard shard, Journal& journal, const RowFn& measure,
                      const ProgressFn& report, const std::atomic<bool>& cancel, std::optional<double> budget_s) {
  const auto started = Clock::now();
  const auto budget_left_s = [&] { return budget_s ? *budget_s - seconds_since(started) : HUGE_VAL; };
  StudyCounts counts;
  std::vector<Todo> todo;
  for (size_t i = 0; i < plan.cases.size(); ++i) {
    if (!shard.takes(i)) continue;
    std::string key = row_key(plan.cases[i].settings);
    if (journal.has(key))
      ++counts.before;
    else
      todo.push_back({&plan.cases[i], std::move(key)});
  }
  const size_t total = counts.before + todo.size();
  double spent_s = 0;  // on measured rows: one that fails at once says nothing about the rest
  const auto report_next = [&](const StudyCase* next) {
    const size_t done = counts.before + counts.measured + counts.failed;
    StudyProgress p{.done = done, .total = total, .failed = counts.failed, .next = next};
    if (counts.measured > 0)
      p.seconds_left =
          std::min(spent_s / double(counts.measured) * double(total - done), std::max(budget_left_s(), 0.0));
    if (report) report(p);
  };
  for (const Todo& t : todo) {
    if (cancel || budget_left_s() <= 0) break;
    report_next(t.study_case);
    const auto begin = Clock::now();
    const std::optional<StudyRow> row = measured(plan, t, measure);
    if (!row) break;
    journal.append(*row);
    ++(row->failed ? counts.failed : counts.measured);
    if (!row->failed) spent_s += seconds_since(begin);
  }
  counts.left = todo.size() - counts.measured - counts.failed;
  report_next(nullptr);
  return counts;
}

}  // namespace gbl
