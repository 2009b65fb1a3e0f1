#pragma once
// What is measured beside the window's picture: one interface, the list of all jobs, and what they have in common.
#include <memory>
#include <vector>

#include "app/lab.h"
#include "ui/ui.h"

namespace gbl {

class BackgroundJob {
 public:
  virtual ~BackgroundJob() = default;
  // Once a frame. `quiet`: nobody touches the window, nothing moves in it and no job before this one in the list is
  // busy; only then is anything measured, a small piece of work at a time.
  virtual void update(const Settings& now, const ui::Requests&, bool quiet) = 0;
  virtual bool busy() const = 0;            // is there more to measure?
  virtual void forget() = 0;                // other programs draw: what was measured says nothing about them
  virtual void fill(ui::Input&) const = 0;  // in what its panel reads
};

// By rank: what runs only while its panel is open comes before what goes on when it is closed.
std::vector<std::unique_ptr<BackgroundJob>> background_jobs(Lab&);

inline constexpr glm::ivec2 kBackgroundSize{320, 180};  // a row then takes about a second on a software driver

// All at one size, whatever is looked at.
Settings as_measured(Settings);

// Error(unfinished) where one frame would hold the window up for too long; `fix`: what to do instead. The reference's
// GPU part is a frame by the plainest method: that one counts, too.
void require_quick(const Settings&, Lab&, const char* where, const char* fix);

}  // namespace gbl
