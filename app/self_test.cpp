#include "app/self_test.h"

#include "app/bench.h"
#include "renderer/base/json.h"
#include "renderer/base/sha256.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"

namespace gbl {
namespace {

// FLIP: half more than that of llvmpipe or softpipe, the larger: drivers round otherwise, and in 16 bits of depth that is
// seen. What a driver does wrong shows in many times that.
struct SelfTestRow {
  const char *id, *what, *preset, *scene;  // scene: null: the preset's
  const char* patch;
  double flip_at_most;
};
// clang-format off
constexpr SelfTestRow kRows[] = {
  {"exact",        "the fewest bytes for half a display step",    "exact",           nullptr, R"({})", 0.003},
  {"compact",      "words of bits, octahedral normals",           "compact",         nullptr, R"({})", 0.0055},
  {"float-sums",   "everything in floats, one blend per light",   "exact",           nullptr, R"({"layout": "float32", "normal.encoding": "xyz32f", "position.source": "view32f", "lights.method": "volumes-instanced", "accumulation.format": "rgba32f", "accumulation.targets": "split"})", 0.0005},
  {"half-sums",    "blends into half floats",                     "compact",         nullptr, R"({"lights.method": "volumes-instanced", "accumulation.format": "rgba16f", "accumulation.targets": "split"})", 0.0055},
  {"stencil",      "volumes that mark the stencil",               "nclgl-fixed",     nullptr, R"({"lights.method": "volumes-stencil"})", 0.0085},
  {"forward",      "surfaces shaded as they are drawn",           "exact",           nullptr, R"({"lights.method": "forward-prepass"})", 0.0005},
  {"tiled",        "lists made by a compute shader",              "exact",           nullptr, R"({"lights.method": "tiled"})", 0.003},
  {"stereo",       "stereographic normals in half floats",        "stereo-fixed",    nullptr, R"({"reflect.size": "64", "shadow.map-size": "256"})", 0.045},
  {"object-ids",   "whole numbers in an attachment",              "objectid-fixed",  nullptr, R"({})", 0.0145},
  {"positions",    "positions in half floats, from the camera",   "compact",         nullptr, R"({"position.source": "view16f"})", 0.0075},
  {"shadows",      "shadow maps of a sun and of lamps",           "exact",           "builtin:room", R"({"shadows": "all", "shadow.map-size": "256"})", 0.0095},
  {"depth-16",     "depth in 16 bits",                            "compact",         nullptr, R"({"depth.format": "d16"})", 0.055},
};
// clang-format on

constexpr glm::ivec2 kSize{96, 54};

Settings settings_of(const SelfTestRow& row, Lab& lab) {
  Settings s = preset(row.preset).make();
  lab.open(row.scene ? row.scene : s.scene);
  if (row.scene) apply_scene(s, row.scene, lab.scene());
  apply_patch(s, parse_patch(row.patch, row.id), row.id);
  s.size = kSize;
  return s;
}

std::string hash_of(const Image& image) {
  return sha256({reinterpret_cast<const char*>(image.rgba.data()), image.rgba.size()}).substr(0, 16);
}

constexpr DeviceLimits all_of_it() {
  DeviceLimits limits;
  for (const FeatureRow& f : kFeatures) limits.features.add(f.feature);
  return limits;
}

void measure(Lab& lab, const Settings& s, SelfTestResult& out) {
  Bench bench(lab.renderer(), lab.cost(), lab.machine(), 1);
  bench.start(s, lab.gpu_scene(), {.errors = true, .times = false});
  bench.step(true);
  const Errors& e = bench.errors();
  out.hash = hash_of(bench.picture());
  if (!e.flip_mean || !e.over_1_255_display || !e.nonfinite_pixels) {
    out.failed = "no pixel shows a surface";
    return;
  }
  out.flip_mean = *e.flip_mean, out.off_pixels = *e.over_1_255_display, out.nonfinite_pixels = *e.nonfinite_pixels;
}

SelfTestResult tested(Lab& lab, const SelfTestRow& row) {
  SelfTestResult out{.id = row.id, .what = row.what, .flip_at_most = row.flip_at_most};
  try {
    const Settings s = settings_of(row, lab);
    require_valid(s, all_of_it());
    const std::vector<Problem> problems = validate(s, lab.limits());
    if (problems.empty())
      measure(lab, s, out);
    else
      out.skipped = problems.front().sentence;
  } catch (const Error& e) {
    out.failed = e.what();
  }
  return out;
}

}  // namespace

std::vector<SelfTestResult> run_self_test(Lab& lab, const std::function<void(const SelfTestResult&)>& done) {
  std::vector<SelfTestResult> out;
  for (const SelfTestRow& row : kRows) {
    out.push_back(tested(lab, row));
    done(out.back());
  }
  return out;
}

Json to_json(const SelfTestResult& r) {
  Json json{{"id", r.id}, {"what", r.what}};
  if (!r.skipped.empty()) {
    json["skipped"] = r.skipped;
    return json;
  }
  json["holds"] = r.holds();
  if (!r.failed.empty()) {
    json["failed"] = r.failed;
    return json;
  }
  json["hash"] = r.hash;
  json["flip_mean"] = r.flip_mean;
  json["flip_at_most"] = r.flip_at_most;
  json["over_1_255_display"] = r.off_pixels;
  json["nonfinite_pixels"] = r.nonfinite_pixels;
  return json;
}

}  // namespace gbl
