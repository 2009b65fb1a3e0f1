#pragma once
// What the reference and the measures need of the GPU, and the truth brought back to it for the eye.
#include <atomic>
#include <future>
#include <optional>

#include "renderer/base/error.h"
#include "renderer/passes/frame.h"
#include "renderer/truth/height_fields.h"
#include "renderer/truth/reference.h"

namespace gbl {

// The same truth, drawn so that the least is lost on this device: forward, everything in float32. What even this
// frame misses is float arithmetic's doing, not a set-up's.
Settings witness_of(const Settings&);
// The errors of a shadow map, a mirror's picture and steps into a height map are no float arithmetic's: such settings have no
// witness, and nothing is excused.
inline bool has_witness(const Settings& s) { return s == lit_alone(s); }

// The truth as textures, for the views `reference` and `error`. Rounded once to float.
struct TruthTextures {
  gl::Texture lit;  // a: 1 where a surface is
  gl::Texture diffuse, specular, normal, position;
  gl::Texture albedo;  // a: roughness
  const gl::Texture& of(ErrorOf) const;
};
TruthTextures upload(const Truth&);

// Everything that a frame of these settings is judged by.
struct TruthSet {
  Settings settings;                   // its truth part counts
  std::shared_ptr<const Scene> scene;  // as it is drawn: of tessellated objects the triangles that were made
  Truth truth;
  std::vector<glm::vec3> witness_lit;  // rows top to bottom
  uint64_t lit_pairs = 0;
  std::vector<SeenTexel> texels;  // what it was worked out from, rows top to bottom
  size_t triangles_replaced = 0;  // of the texels: those whose triangle this driver got wrong
  TruthTextures textures;
};

// Makes a TruthSet without ever making the window wait: the GPU is asked, the CPU works on threads of its own, or, where there
// are none, a little in each step.
class TruthMaker {
 public:
  TruthMaker(const Settings&, int threads);
  ~TruthMaker();  // cancels

  const Settings& settings() const { return settings_; }
  double progress() const;  // 0..1

  // Does what can be done now; the set, once, when it is there. `wait` blocks until then.
  std::shared_ptr<const TruthSet> step(Renderer&, const GpuScene&, bool wait);

 private:
  void ask_gpu(Renderer&, const GpuScene&);
  std::optional<std::vector<SeenTexel>> take_texels(bool wait);
  bool sampled_below(Renderer&, const GpuScene&, const std::vector<SeenTexel>&, bool wait);
  bool started(Renderer&, const GpuScene&, bool wait);
  bool work(double at_most_ms);
  bool finished(bool wait);

  Settings settings_;
  int threads_;
  bool asked_ = false, asked_below_ = false;
  Targets targets_;  // of the frame block, the instances and the witness
  std::array<gl::Texture, kSeenTexels> seen_;
  gl::Texture depth_;
  gl::Framebuffer framebuffer_;
  std::array<gl::AsyncRead, kSeenTexels> reads_;
  gl::AsyncRead witness_read_;
  std::array<std::vector<glm::vec4>, kSeenTexels> seen_texels_;
  std::future<std::vector<glm::vec4>> uvs_moved_;
  std::vector<glm::vec3> witness_lit_;
  std::shared_ptr<const Scene> scene_;  // as it is drawn
  std::unique_ptr<Reference> reference_;
  std::atomic<bool> cancel_{false};
  size_t triangles_replaced_ = 0;
  enum class Stage { texels, rivals, rows } stage_ = Stage::texels;
  std::optional<Error> refused_;
  std::future<bool> work_;  // where there are threads
};

// Linear radiance as drawn, rows top to bottom; waits for the GPU.
std::vector<glm::vec3> read_lit(const Targets&);

// What a set-up made of the truth; draws, and waits for the GPU. With `unlit` the frame is drawn once more without
// lights, and the targets then hold that frame.
Drawn read_drawn(Renderer&, const Settings& drawn, const GpuScene&, Targets&, bool unlit);

}  // namespace gbl
