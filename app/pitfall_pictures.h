#pragma once
// The small pictures in the list of pitfalls: both sides of each entry, drawn while the list is open, one at a time.
#include <memory>
#include <vector>

#include "app/background.h"
#include "renderer/study/pitfalls/judge.h"

namespace gbl {

class PitfallPictures : public BackgroundJob {
 public:
  explicit PitfallPictures(Lab& lab) : lab_(lab) {}

  void update(const Settings& now, const ui::Requests&, bool quiet) override;
  bool busy() const override { return open_ && next_ < todo_.size(); }
  void forget() override;
  void fill(ui::Input& in) const override { in.pitfall_pictures = &shown_; }

 private:
  struct Todo {
    PitfallEntry entry;
    PitfallSide side;
  };
  void make_list();
  void draw(const Todo&);
  void let_go();

  Lab& lab_;
  bool open_ = false;
  std::vector<Todo> todo_;  // by scene
  size_t next_ = 0;
  std::shared_ptr<const GpuScene> scene_;  // only while the list is drawn
  std::string scene_name_;
  std::unique_ptr<Targets> targets_;
  std::vector<Canvas> canvases_;
  ui::PitfallPictures shown_;
};

}  // namespace gbl
