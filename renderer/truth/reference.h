#pragma once
// The truth: the seen triangle, then everything anew on the CPU in double, every light by brute force in light order.
// No light lists: they would share the failure that is judged. It depends on the truth part of Settings and on nothing
// else; mistakes are never true.
#include <atomic>
#include <limits>
#include <memory>

#include "renderer/truth/surface_light.h"
#include "renderer/truth/truth.h"
#include "renderer/truth/truth_geometry.h"
#include "renderer/truth/visible_triangles.h"

namespace gbl {

class Reference {
 public:
  // texels: size.x * size.y of the settings, rows top to bottom.
  // With `store` it is no truth, but what that way of storing materials would leave of it.
  Reference(const Settings&, std::shared_ptr<const Scene>, std::vector<SeenTexel> texels, StoreFn store = {});

  // The texels' triangles against the scene, in double (visible_triangles.h); the number of those replaced.
  size_t check_texels() { return check_triangles(settings_, *scene_, texels_); }

  // Both are false if cancelled or when their time is up; called again they go on. A ninth or a row is done each time, and none is left
  // half done.
  static constexpr double kAllOfIt = std::numeric_limits<double>::infinity();
  // What ties are told by (ties.h). A truth without it knows none.
  bool find_rivals(const std::atomic<bool>* cancel = nullptr, double at_most_ms = kAllOfIt);
  // The rows that are not done yet. The result does not depend on the number of threads.
  bool run(int threads, const std::atomic<bool>* cancel = nullptr, double at_most_ms = kAllOfIt);
  double progress() const;  // 0..1; may be asked while run() works

  const Settings& settings() const { return settings_; }
  const std::vector<SeenTexel>& texels() const { return texels_; }
  const Truth& truth() const { return truth_; }  // complete when progress() is 1
  // (pixel, light) pairs in which the light reaches the surface, whatever it faces.
  uint64_t lit_pairs() const;

 private:
  void work_row(int y);
  void work_pixel(glm::ivec2 pixel);
  void add_mirrored(size_t i, const SurfaceLight::Mirrored&);

  Settings settings_;
  std::shared_ptr<const Scene> scene_;
  std::vector<SeenTexel> texels_;
  TruthGeometry geometry_;
  SurfaceLight light_;
  Truth truth_;
  std::vector<uint64_t> lit_pairs_of_row_;
  int next_rival_place_ = 0;
  std::atomic<int> next_row_{0}, rows_done_{0};
};

}  // namespace gbl
