#pragma once
// Set-ups measured while the window goes on: a study in the scene and with the truth at hand, and the settings at hand
// themselves. A small piece of work a frame, with targets of its own, and only while nothing else wants the machine.
// Rows are kept in memory, and are shown only beside the truth that they were measured with.
#include <list>

#include "app/background.h"
#include "app/bench.h"
#include "renderer/study/study_spec.h"

namespace gbl {

class BackgroundStudy : public BackgroundJob {
 public:
  explicit BackgroundStudy(Lab&);

  void update(const Settings& now, const ui::Requests&, bool quiet) override;
  bool busy() const override { return running_ || task_ != Task::none || wanted_; }
  void forget() override;
  void fill(ui::Input& in) const override { in.chart = &shown_; }

 private:
  struct Row {
    StudyRow row;
    Settings settings;  // as asked for
  };
  struct Run {
    std::string study;
    Settings truth;
    std::vector<std::string> varied;  // paths of the truth that its cases differ in
    StudyPlan plan;
    std::vector<Row> rows;  // of the first so many cases
    double spent_s = 0;     // on them
    bool complete() const { return rows.size() == plan.cases.size(); }
    bool fits(const Settings&) const;  // is this its truth?
  };
  enum class Task { none, study, at_hand };

  void take(const ui::ChartRequest&, const Settings& now);
  void list_studies();
  void start(const std::string& study, const Settings& now);
  Run make_run(const std::string& study, const Settings& now) const;
  void stop(const std::string& why);
  void give_up();
  void work(const Settings& now);
  bool begin_next(const Settings& now);
  void finish(StudyRow row);
  Run* run_here(const std::string& study, const Settings& now);
  void show(const Settings& now);
  void show_progress(const Run*);
  std::string words_for(const Run*) const;

  Lab& lab_;
  std::optional<Bench> bench_;  // from the first measurement on
  std::shared_ptr<const GpuScene> scene_;
  std::list<Run> runs_;  // the latest first
  Run* running_ = nullptr;
  std::vector<Row> tried_;  // settings that were at hand
  Task task_ = Task::none;
  StudyCase measured_;  // by the task
  double begun_s_ = 0;
  bool wanted_ = false;  // the settings at hand are to be measured
  bool changed_ = true;  // the rows, or which are chosen
  std::string study_;    // whose rows are shown
  std::string note_;     // what became of the study that ran last
  Settings shown_for_;
  ui::ChartInput shown_;
};

}  // namespace gbl
