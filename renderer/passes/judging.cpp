#include "renderer/passes/judging.h"

#include <algorithm>

#include "renderer/base/threads.h"
#include "renderer/gl/device.h"
#include "renderer/passes/float_rows.h"

namespace gbl {
namespace {

// A picture of doubles as a texture: colour(i) and alpha(i) of pixel i, rows top to bottom.
template <class Colour, class Alpha>
gl::Texture uploaded(glm::ivec2 size, const char* label, Colour colour, Alpha alpha) {
  const auto width = static_cast<size_t>(size.x), height = static_cast<size_t>(size.y);
  std::vector<glm::vec4> texels(width * height);
  for (size_t y = 0; y < height; ++y)
    for (size_t x = 0; x < width; ++x) {
      const size_t i = (height - 1 - y) * width + x;
      texels[y * width + x] = glm::vec4(glm::vec3(colour(i)), static_cast<float>(alpha(i)));
    }
  gl::Texture t = gl::make_texture({.size = size, .format = Format::rgba32f, .label = label});
  gl::write_texels(t, texels.data());
  return t;
}

constexpr double kSliceMs = 12;  // of a frame, where the window's thread is the only one
constexpr const char* kSeenLabels[] = {"seen.triangle", "seen.base", "seen.normal", "seen.emission", "seen.specular"};

}  // namespace

Settings witness_of(const Settings& s) {
  Settings w = s;
  w.lights.method = LightMethod::forward;
  w.lights.markers = LightMarkers::off;
  w.layout = Layout::float32, w.layout_file.clear();
  w.depth.format = DepthFormat::auto_;
  w.accumulation = {AccumulationFormat::rgba32f, AccumulationTargets::one};
  w.background.skip = BackgroundSkip::depth;
  w.parallax = {ParallaxMethod::none, 1, ParallaxDepth::displaced};
  w.tangents = Tangents::vertex;
  w.antialias = Antialias::none;
  w.draw_order = DrawOrder::near_far;
  w.mistakes.clear();
  w.view = {};
  return w;
}

const gl::Texture& TruthTextures::of(ErrorOf what) const {
  switch (what) {
    case ErrorOf::final:
    case ErrorOf::lit: return lit;
    case ErrorOf::diffuse_light: return diffuse;
    case ErrorOf::specular_light: return specular;
    case ErrorOf::normal: return normal;
    case ErrorOf::position:
    case ErrorOf::depth: return position;
    case ErrorOf::albedo:
    case ErrorOf::roughness: return albedo;
  }
  return lit;
}

TruthTextures upload(const Truth& t) {
  const auto one = [](size_t) { return 1.0; };
  const auto of = [&](const char* label, const std::vector<glm::dvec3>& list) {
    return uploaded(
        t.size, label, [&](size_t i) { return list[i]; }, one);
  };
  TruthTextures out;
  out.lit = uploaded(
      t.size, "truth.lit", [&](size_t i) { return t.lit[i]; }, [&](size_t i) { return double(t.present[i]); });
  out.diffuse = of("truth.diffuse", t.diffuse);
  out.specular = of("truth.specular", t.specular);
  out.normal = of("truth.normal", t.normal);
  out.position = of("truth.position", t.position);
  out.albedo = uploaded(
      t.size, "truth.albedo", [&](size_t i) { return t.albedo[i]; }, [&](size_t i) { return t.roughness[i]; });
  return out;
}

TruthMaker::TruthMaker(const Settings& s, int threads) : settings_(witness_of(s)), threads_(threads) {}

TruthMaker::~TruthMaker() {
  cancel_ = true;
  if (uvs_moved_.valid()) uvs_moved_.wait();
  if (work_.valid()) work_.wait();
}

double TruthMaker::progress() const { return reference_ ? reference_->progress() : 0; }

void TruthMaker::ask_gpu(Renderer& renderer, const GpuScene& scene) {
  gl::FramebufferDesc desc{.label = "seen"};
  for (size_t k = 0; k < seen_.size(); ++k) {
    seen_[k] = gl::make_texture({.size = settings_.size, .format = Format::rgba32f, .label = kSeenLabels[k]});
    desc.colours.push_back(&seen_[k]);
  }
  depth_ = gl::make_texture({.size = settings_.size, .format = Format::d32f, .label = "seen.depth"});
  desc.depth = &depth_;
  framebuffer_ = gl::make_framebuffer(desc);
  renderer.render(lit_alone(settings_), scene, targets_);
  witness_read_.start(*targets_.frame.texture(Stores::lit));
  renderer.draw_seen(settings_, scene, targets_, framebuffer_);
  for (size_t k = 0; k < seen_.size(); ++k) reads_[k].start(seen_[k]);
  asked_ = true;
}

// When all of the GPU's answers are there.
std::optional<std::vector<SeenTexel>> TruthMaker::take_texels(bool wait) {
  if (const std::vector<float>* lit = witness_read_.take(wait))
    witness_lit_ = rows_from_top<glm::vec3>(settings_.size, *lit);
  for (size_t k = 0; k < reads_.size(); ++k)
    if (const std::vector<float>* texels = reads_[k].take(wait))
      seen_texels_[k] = rows_from_top<glm::vec4>(settings_.size, *texels);
  for (const auto& list : seen_texels_)
    if (list.empty()) return std::nullopt;
  if (witness_lit_.empty()) return std::nullopt;
  std::vector<SeenTexel> texels(witness_lit_.size());
  for (size_t i = 0; i < texels.size(); ++i)
    texels[i] = {seen_texels_[0][i], seen_texels_[1][i], seen_texels_[2][i], seen_texels_[3][i], seen_texels_[4][i]};
  return texels;
}

// Where surfaces lie below their triangles, textures are read again there: where that is, is known when the triangles are.
bool TruthMaker::sampled_below(Renderer& renderer, const GpuScene& scene, const std::vector<SeenTexel>& texels,
                               bool wait) {
  const auto deep = [&](const Instance& i) { return has_heights(scene_->materials[static_cast<size_t>(i.material)]); };
  if (asked_below_ || settings_.height_map == HeightMap::off) return true;
  if (std::none_of(scene_->instances.begin(), scene_->instances.end(), deep)) return true;
  if (!uvs_moved_.valid())
    uvs_moved_ = in_background(
        [this, texels] { return uvs_moved(HeightFields(settings_, *scene_), settings_, texels, threads_, &cancel_); });
  if (!wait && uvs_moved_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  const std::vector<glm::vec4> moved = uvs_moved_.get();
  const gl::Texture uvs = uploaded(
      settings_.size, "seen.uvs_moved", [&](size_t i) { return moved[i]; }, [](size_t) { return 0.0; });
  renderer.draw_seen(settings_, scene, targets_, framebuffer_, &uvs);
  seen_texels_ = {};
  for (size_t k = 0; k < seen_.size(); ++k) reads_[k].start(seen_[k]);
  asked_below_ = true;
  return false;
}

// Does the CPU work already?
bool TruthMaker::started(Renderer& renderer, const GpuScene& scene, bool wait) {
  if (reference_) return true;
  const auto under_way = [&] {
    return uvs_moved_.valid() && uvs_moved_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  };
  if (!wait && under_way()) return false;
  std::optional<std::vector<SeenTexel>> texels = take_texels(wait);
  if (texels && !scene_) scene_ = targets_.tessellation.drawn(scene);  // it has been drawn, so that nobody waits
  if (texels && !sampled_below(renderer, scene, *texels, wait)) texels = wait ? take_texels(wait) : std::nullopt;
  if (!texels) return false;
  reference_ = std::make_unique<Reference>(settings_, scene_, std::move(*texels));
  if (kHasThreads) work_ = in_background([this] { return work(Reference::kAllOfIt); });
  return true;
}

// True when all is done. Of the stages one is gone on with.
bool TruthMaker::work(double at_most_ms) {
  switch (stage_) {
    case Stage::texels: triangles_replaced_ = reference_->check_texels(), stage_ = Stage::rivals; break;
    case Stage::rivals:
      if (reference_->find_rivals(&cancel_, at_most_ms)) stage_ = Stage::rows;
      break;
    case Stage::rows: return reference_->run(threads_, &cancel_, at_most_ms);
  }
  return at_most_ms == Reference::kAllOfIt && !cancel_ && work(at_most_ms);
}

bool TruthMaker::finished(bool wait) {
  if (!work_.valid()) return work(wait ? Reference::kAllOfIt : kSliceMs);
  if (!wait && work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  work_.get();
  return true;
}

std::shared_ptr<const TruthSet> TruthMaker::step(Renderer& renderer, const GpuScene& scene, bool wait) {
  if (refused_) throw Error(*refused_);  // asked again it would be no better
  if (!asked_) ask_gpu(renderer, scene);
  if (!started(renderer, scene, wait)) return nullptr;
  try {
    if (!finished(wait)) return nullptr;
  } catch (const Error& e) {
    refused_ = e;
    throw;
  }
  auto set = std::make_shared<TruthSet>();
  set->settings = settings_;
  set->scene = scene_;
  set->truth = reference_->truth();
  if (has_witness(settings_)) set->witness_lit = std::move(witness_lit_);
  set->lit_pairs = reference_->lit_pairs();
  set->texels = reference_->texels();
  set->triangles_replaced = triangles_replaced_;
  set->textures = upload(set->truth);
  return set;
}

std::vector<glm::vec3> read_lit(const Targets& t) {
  return rows_from_top<glm::vec3>(t.frame.size(), gl::read_rgba32f(*t.frame.texture(Stores::lit)));
}

Drawn read_drawn(Renderer& renderer, const Settings& drawn, const GpuScene& scene, Targets& targets, bool unlit) {
  Drawn out;
  out.lit = read_lit(targets);
  out.shown = rows_from_top<glm::vec3>(targets.frame.size(), gl::read_rgba32f(targets.canvases.shown(targets.frame)));
  gl::Texture normal = gl::make_texture({.size = drawn.size, .format = Format::rgba32f, .label = "decoded.normal"});
  gl::Texture position = gl::make_texture({.size = drawn.size, .format = Format::rgba32f, .label = "decoded.position"});
  const gl::Framebuffer into = gl::make_framebuffer({.colours = {&normal, &position}, .label = "decoded"});
  renderer.draw_decoded(drawn, scene, targets, into);
  const auto normals = rows_from_top<glm::vec4>(drawn.size, gl::read_rgba32f(normal));
  const auto positions = rows_from_top<glm::vec4>(drawn.size, gl::read_rgba32f(position));
  if (shading_of(drawn.lights.method) != Shading::forward) out.normal.assign(normals.begin(), normals.end());
  out.position.assign(positions.begin(), positions.end());
  for (size_t i = 0; i < normals.size(); ++i)
    out.seen.push_back({static_cast<int>(normals[i].w), static_cast<int>(positions[i].w)});
  out.depth = rows_from_top<float>(targets.frame.size(), gl::read_depth(*targets.frame.texture(Stores::depth)));
  if (!unlit) return out;
  Settings dark = drawn;
  dark.lights.first = 0;
  renderer.render(dark, scene, targets);
  out.unlit = read_lit(targets);
  return out;
}

}  // namespace gbl
