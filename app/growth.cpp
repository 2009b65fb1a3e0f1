#include "app/growth.h"

#include <cmath>
#include <fmt/format.h>

#include "app/bench.h"
#include "renderer/base/error.h"
#include "renderer/base/memory.h"
#include "renderer/scenes/mesh_builder.h"
#include "renderer/study/charts/gnuplot.h"

namespace gbl {
namespace {

// A ball that fills most of the picture, of about so many triangles, with a light before it.
std::shared_ptr<const Scene> ball_of(double triangles) {
  auto scene = std::make_shared<Scene>();
  scene->name = fmt::format("a ball of {:.0f} triangles", triangles);
  const int sides = static_cast<int>(std::lround(std::sqrt(triangles)));
  scene->meshes = {make_ellipsoid({1, 1, 1}, sides, sides / 2)};
  scene->materials = {{.name = "white"}};
  scene->instances = {{"ball", 0, 0, glm::dmat4(1)}};
  scene->light_box = LightBox{{-1.5, -1.5, 1.2}, {1.5, 1.5, 2}, BoxRange::fixed};
  scene->light_box->range = 0.4;
  scene->camera.position = {0, 0, 2.6}, scene->camera.near = 0.1, scene->camera.far = 20;
  scene->bounds = bounds_of(*scene);
  return scene;
}

double ms_of(const MeasuredColumns& row, const std::string& pass) {
  const std::string column = fmt::format("time_ms_{}_median", pass);
  for (const Cell& c : row.cells)
    if (c.column == column)
      if (const auto* n = std::get_if<Number>(&c.value)) return n->value;
  return 0;
}

double pixels_of(const Settings& s) { return double(s.size.x) * s.size.y; }

std::optional<double> as_set(const Settings&, const FrameReport&, double value) { return value; }
std::optional<double> lit_per_pixel(const Settings& s, const FrameReport& r, double) {
  if (!r.pairs || !r.pairs->lit || *r.pairs->lit == 0) return {};
  return double(*r.pairs->lit) / pixels_of(s);
}

}  // namespace

std::span<const GrowthAxis> growth_axes() {
  static const std::vector<GrowthAxis> kAxes = {
      {"lights",
       "lights",
       "16 to 16 384, ranges as the scene has them",
       {16, 64, 256, 1024, 4096, 16384},
       [](Settings& s, double v) { s.lights.source = LightSource::generated, s.lights.count = static_cast<int>(v); },
       as_set,
       {"--lights"}},
      {"pixels",
       "pixels",
       "0.06 to 8.3 million, 16:9",
       {320, 640, 960, 1280, 1920, 2560, 3840},
       [](Settings& s, double v) {
         s.size = {static_cast<int>(v), static_cast<int>(v) * 9 / 16};
       },
       [](const Settings& s, const FrameReport&, double) { return std::optional(pixels_of(s)); },
       {"--size"}},
      {"overlap",
       "lights that reach a pixel, the mean",
       "256 lights, ranges from half to 32 times",
       {0.5, 1, 2, 4, 8, 32},
       [](Settings& s, double v) {
         s.lights.source = LightSource::generated;
         s.lights.count = 256, s.lights.range_scale = v;
       },
       lit_per_pixel,
       {"--lights"}},
      {"triangles",
       "triangles",
       "a ball of 1000 to 5 million",
       {1e3, 1e4, 1e5, 1e6, 5e6},
       [](Settings& s, double v) { s.lights.source = LightSource::generated, s.scene = fmt::format("ball:{}", v); },
       as_set,
       {"--scene", "--camera"},
       ball_of},
  };
  return kAxes;
}

const GrowthAxis& growth_axis(std::string_view id) {
  std::vector<std::string_view> known;
  for (const GrowthAxis& a : growth_axes()) {
    if (id == a.id) return a;
    known.emplace_back(a.id);
  }
  throw Error(ExitCode::bad_input, "--growth", fmt::format("'{}' is not known", id), suggest(id, known));
}

std::vector<GrowthRow> measure_growth(Lab& lab, const Settings& asked, const GrowthAxis& axis, int frames,
                                      const std::function<void(const GrowthRow&)>& done) {
  std::vector<GrowthRow> rows;
  for (const double value : axis.values) {
    Settings s = asked;
    axis.set(s, value);
    GrowthRow row;
    if (axis.scene) {
      const std::shared_ptr<const Scene> scene = axis.scene(value);
      s.camera = scene->camera;
      const double begin = now_s();
      lab.show(s.scene, scene);
      glFinish();
      row.upload_ms = (now_s() - begin) * 1e3;
    }
    require_valid(s, lab.limits());
    Bench bench(lab.renderer(), lab.cost(), lab.machine(), 1);
    bench.start(s, lab.gpu_scene(), {.errors = false, .frames = frames, .all_frames = true});
    bench.step(true);
    const MeasuredColumns measured = bench.row();
    row.total_ms = ms_of(measured, "total"), row.geometry_ms = ms_of(measured, "geometry");
    row.rest_ms = row.total_ms - row.geometry_ms;
    const FrameReport& r = bench.report();
    if (r.pairs) row.tested_per_pixel = double(r.pairs->tested) / pixels_of(s);
    const std::optional<double> place = axis.place(s, r, value);
    // Nothing is timed, or everything was reached before: no place on this axis, either.
    if (!place || !(row.total_ms > 0) || (!rows.empty() && *place < 1.01 * rows.back().x)) continue;
    row.x = *place;
    row.targets_mib = r.mib, row.resident_mib = double(resident_bytes()) / (1 << 20);
    rows.push_back(row);
    done(row);
  }
  return rows;
}

std::string growth_script(const GrowthAxis& axis, std::span<const GrowthRow> rows, const std::string& subtitle) {
  std::string text = "set terminal svg size 760,460 font 'sans-serif,13' background 'white'\n";
  text +=
      fmt::format("set title {}\n", gnuplot_text(fmt::format("Time of a frame against {}: {}", axis.label, subtitle)));
  text += fmt::format("set logscale xy\nset xlabel {}\nset ylabel 'ms'\nset key left top\nset grid\n",
                      gnuplot_text(axis.label));
  const bool prefixes = !rows.empty() && rows.back().x >= 1000;  // 10 k; but a hundredth is not 10 m
  text += prefixes ? "set format x '%.0s %c'\n" : "set format x '%g'\n";
  text += "$rows << EOD\n";
  for (const GrowthRow& r : rows) text += fmt::format("{} {} {} {}\n", r.x, r.total_ms, r.geometry_ms, r.rest_ms);
  text += "EOD\nplot ";
  constexpr const char* kCurves[] = {"frame", "fill", "all that follows"};
  for (size_t i = 0; i < std::size(kCurves); ++i)
    text += fmt::format("{}$rows using 1:{} with linespoints lw 2 pt {} lc rgb '{}' title {}", i > 0 ? ", " : "", i + 2,
                        series_shape(i, true), series_colour(i), gnuplot_text(kCurves[i]));
  return text + "\n";
}

}  // namespace gbl
