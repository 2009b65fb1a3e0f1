// Pictures without a window: each view as a PNG, a captioned sheet, and the start sheets.
#include <fmt/format.h>
#include <future>
#include <sstream>

#include "app/commands.h"
#include "app/headless.h"
#include "app/imgui_screen.h"
#include "app/lab.h"
#include "app/layers_exr.h"
#include "app/picture_texts.h"
#include "app/report_json.h"
#include "app/sheet_maker.h"
#include "app/truth_drawing.h"
#include "app/window_picture.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/base/size_text.h"
#include "renderer/base/threads.h"
#include "renderer/frame/packing_svg.h"
#include "renderer/inspect/view_buffers.h"
#include "renderer/opening/scene_look.h"
#include "renderer/options/options.h"
#include "renderer/options/presets.h"
#include "renderer/options/settings_json.h"
#include "ui/figure.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;
constexpr double kWarnMs = 5000;  // a frame predicted longer than this is announced

std::vector<View> wanted_views(const Arguments& a, const Settings& s) {
  std::vector<View> out;
  if (a.only.empty()) {
    for (const ViewRow& v : views())
      if (*v.key && why_missing(v.view, s).empty()) out.push_back(v.view);
    return out;
  }
  std::istringstream list(a.only);
  for (std::string id; std::getline(list, id, ',');) {
    const View v = view_by_id(id).view;
    const std::string missing = why_missing(v, s);
    if (!missing.empty()) throw Error(ExitCode::bad_input, fmt::format("--only {}", id), missing);
    if (std::find(out.begin(), out.end(), v) == out.end()) out.push_back(v);  // named twice, drawn once
  }
  return out;
}

void announce(Lab& lab, const Settings& s) {
  lab.open(s.scene);
  const double ms = lab.cost().predict_ms(*lab.resolve(s));
  if (ms > kWarnMs) fmt::print(stderr, "gbufferlab: this frame is predicted to take about {:.0f} s\n", ms / 1000);
}

// PNGs are packed on other threads while the GPU draws the next view.
class Writer {
 public:
  explicit Writer(fs::path folder) : folder_(std::move(folder)) {}
  void write(const std::string& name, Image image, PngText texts) {
    written_.push_back(name);
    tasks_.push_back(in_background(
        [this, name, image = std::move(image), texts = std::move(texts)] { write_png(folder_ / name, image, texts); }));
  }
  std::vector<std::string> finish() {
    for (auto& t : tasks_) t.get();
    return written_;
  }

 private:
  fs::path folder_;
  std::vector<std::future<void>> tasks_;
  std::vector<std::string> written_;
};

// Overlays are laid over the views that are asked for by name; else over the main one, as in the window.
bool overlaid(const Arguments& a, const Lab& lab, View v) {
  return !needs_truth(v) && (!a.only.empty() || lab.is_main(v));
}

// The view's own numbers: 0 is black and 65535 white; both stand in the file, in the view's unit.
void write_numbers16(const fs::path& path, Lab& lab, View v, PngText texts) {
  const glm::dvec2 range = shown_range(v, lab.drawn(), lab.scene().bounds, lab.stats_of(v));
  std::vector<glm::vec3> rgb;
  for (const glm::vec4& n : lab.numbers_of(v)) {
    const glm::vec3 of_range((glm::dvec3(n) - range.x) / (range.y - range.x));
    rgb.push_back(row(v).values.components == 1 ? glm::vec3(of_range.x) : of_range);
  }
  texts.push_back({"gbufferlab-range", fmt::format("{} {} {}", range.x, range.y, row(v).unit)});
  write_png16(path, lab.drawn().size, rgb, texts);
}

void refuse_truth_as_overlay(const Settings& s) {
  for (const Overlay& o : s.view.overlays)
    if (const View v = view_by_id(o.view).view; needs_truth(v))
      throw Error(ExitCode::bad_input, fmt::format("view.overlays: {}", o.view), why_not_over(v, s));
}

// What this frame does not have is left out, and said: the same settings may be drawn by another method next.
void say_missing_overlays(const Settings& drawn) {
  for (const Overlay& o : drawn.view.overlays)
    if (const std::string why = why_not_over(view_by_id(o.view).view, drawn); !why.empty())
      fmt::print(stderr, "gbufferlab: view.overlays: {}: {}\n", o.view, why);
}

Image sheet_of(const Arguments& a, Lab& lab, const std::vector<View>& views_shown) {
  SheetMaker maker;
  maker.sheet().title = "G-Buffer Lab";
  maker.sheet().caption = ui::made_in_words(lab.drawn(), lab.report());
  for (const View v : views_shown) {
    if (!needs_truth(v)) lab.draw_measured_view(v, {.overlays = overlaid(a, lab, v)});
    maker.add(lab, v, overlaid(a, lab, v));
  }
  return maker.picture();
}

std::string command_of(const Arguments& a) {
  return a.without.empty() ? "gbufferlab render" : fmt::format("gbufferlab render --without {}", a.without);
}

}  // namespace

ExitCode run_render(const Arguments& a) {
  const Setup setup = setup_of(a);
  const Settings& s = setup.settings;
  const std::shared_ptr<const Scene>& scene = setup.scene;
  const HeadlessContext context(api_of(a));
  Lab lab(without_of(a));
  if (scene) lab.show(s.scene, scene);
  if (scene)
    for (const std::string& w : notes_of(*scene, s.lights.source))
      fmt::print(stderr, "gbufferlab: {}: {}\n", s.scene, w);
  require_valid(s, lab.limits());
  refuse_truth_as_overlay(s);
  const std::vector<View> shown = wanted_views(a, s);
  const std::string all = a.only.empty() ? "" : fmt::format(" --only {}", a.only);
  const fs::path folder = a.output.value_or("out");
  make_folder(folder);
  announce(lab, s);
  lab.draw(s);
  say_missing_overlays(lab.report().drawn);
  lab.count_pairs(double(s.size.x) * s.size.y * lab.report().light_count <= kMostLitTests);
  const std::string command = command_of(a);
  const auto texts = [&](const std::string& options) { return picture_texts(command + options, s, lab.machine()); };
  Writer writer(folder);
  size_t numbers16 = 0;
  for (const View v : shown) {
    draw_any_view(lab, v, overlaid(a, lab, v));
    const std::string only = fmt::format(" --only {}", row(v).id);
    writer.write(fmt::format("{}.png", row(v).id), lab.image_of(v), texts(only));
    if (a.png16 && !needs_truth(v)) {
      write_numbers16(folder / fmt::format("{}.16.png", row(v).id), lab, v, texts(only + " --png16"));
      ++numbers16;
    }
    if (!a.raw || needs_truth(v)) continue;
    lab.draw_view(v, {.raw = true});
    writer.write(fmt::format("{}.raw.png", row(v).id), lab.image_of(v), texts(only + " --raw"));
  }
  if (a.exr) write_layers(folder / "layers.exr", lab, shown, texts(all + " --exr"));
  lab.collect(true);
  if (a.sheet) {
    writer.write("sheet.png", sheet_of(a, lab, shown), texts(all + " --sheet"));
    const Preset* p = preset_of(s);
    write_text_file(folder / "packing.svg",
                    packing_svg(lab.report().drawn, p ? p->id : layout_of(lab.report().drawn).axis.id));
  }
  write_text_file(folder / "settings.json", settings_text(s) + "\n");
  const std::vector<std::string> files = writer.finish();
  say_choices(lab.report().choices);
  if (a.json)
    fmt::print("{}\n", report_json(lab).dump(2));
  else
    fmt::print("{}\n{} pictures{} and settings.json in {}\n", ui::made_in_words(s, lab.report()),
               files.size() + numbers16, a.exr ? ", layers.exr" : "", folder.string());
  return ExitCode::done;
}

namespace {

// The final picture under three culling rules, side by side.
Image three_culls(Lab& lab, Settings s) {
  SheetMaker maker;
  ui::Sheet& sheet = maker.sheet();
  sheet.title = "Which faces of a light volume are drawn?";
  sheet.columns = 3, sheet.tile_width = 640;
  for (const LightCull cull : {LightCull::flip, LightCull::back, LightCull::none}) {
    s.lights.cull = cull;
    lab.draw(s);
    lab.draw_view(View::final);
    maker.add(lab, View::final, false).caption = fmt::format("cull {}: {}", row(cull).id, row(cull).help);
  }
  sheet.caption = "The camera stands inside the volumes of two lights, and outside all others.";
  return maker.picture();
}

}  // namespace

ExitCode run_start_sheets(const Arguments& a) {
  Settings s = setup_of(a).settings;
  s.size = {800, 450};  // the first screen's large picture
  const HeadlessContext context(api_of(a));
  Lab lab(without_of(a));
  const fs::path folder = "out";
  make_folder(folder);
  const PngText texts = picture_texts("gbufferlab", s, lab.machine());
  write_png(folder / "start.png", first_screen(lab, s, {1600, 900}, true), texts);
  write_png(folder / "start_cull.png", three_culls(lab, s), texts);
  fmt::print("No display: wrote the first screen instead.\n  {}\n  {}\n", (folder / "start.png").string(),
             (folder / "start_cull.png").string());
  return ExitCode::done;
}

}  // namespace gbl
