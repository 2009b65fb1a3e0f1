#pragma once
// Compiles the programs of all presets while nobody touches the window, so that the next preset is there at once: each
// is drawn a few pixels large, its frame first, then one view after the other.
#include "app/background.h"

namespace gbl {

class BackgroundWarmUp : public BackgroundJob {
 public:
  explicit BackgroundWarmUp(Lab& lab) : lab_(lab) {}

  void update(const Settings& now, const ui::Requests&, bool quiet) override;
  bool busy() const override { return begun_ && !done(); }
  void forget() override { next_ = {}; }
  void fill(ui::Input&) const override {}

 private:
  struct Place {
    size_t preset = 0;
    int view = -1;  // -1: the frame that the views show
  };
  bool done() const;
  void draw(const Settings&);
  void work(glm::ivec2 window_size, const ui::Requests&);
  void draw_next(glm::ivec2 window_size, const ui::Requests&);

  Lab& lab_;
  bool begun_ = false;
  Place next_;
  Settings drawn_;
  std::unique_ptr<GpuScene> scene_;  // only while it works
  std::string scene_name_;
  std::unique_ptr<Targets> targets_;
};

}  // namespace gbl
