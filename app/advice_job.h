#pragma once
// advise() on a thread of its own. What it asks of the device waits here until whoever owns the GL context has measured
// it, a piece at a time; the thread itself never touches GL.
#include <condition_variable>
#include <mutex>
#include <thread>
#include <variant>

#include "renderer/study/advice/advisor.h"

namespace gbl {

class AdviceJob {
 public:
  AdviceJob(const Settings& truth, std::shared_ptr<const Scene>, const ErrorBudget&, AdviceCost, const DeviceLimits&);
  ~AdviceJob();  // gives it up, whatever it waits for
  AdviceJob(const AdviceJob&) = delete;
  AdviceJob& operator=(const AdviceJob&) = delete;

  struct Question {
    Settings setup;
    std::optional<int> camera;  // is the bound held from it? empty: what does the set-up cost?
  };
  using Answer = std::variant<BoundCheck, double, std::exception_ptr>;
  std::optional<Question> question() const;  // that waits for its answer
  void answer(Answer);

  bool finished() const;
  Advice advice();  // of a finished one; throws what it threw
  size_t tried() const;
  std::string progress() const;  // what is tried now

 private:
  void run(const Settings& truth, const Scene&, const ErrorBudget&, AdviceCost, const DeviceLimits&);
  Answer ask(Question);

  mutable std::mutex mutex_;  // of all below
  std::condition_variable answered_;
  std::optional<Question> question_;
  std::optional<Answer> answer_;
  std::string progress_;
  size_t tried_ = 0;
  bool finished_ = false;
  Advice advice_;
  std::exception_ptr error_;
  std::atomic<bool> cancel_{false};
  std::thread thread_;  // the last: it uses the others
};

}  // namespace gbl
