#include "app/figure_maker.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/layers_exr.h"
#include "app/sheet_maker.h"
#include "app/truth_drawing.h"
#include "app/window_picture.h"
#include "renderer/figures/drawings.h"
#include "renderer/frame/validate.h"
#include "renderer/options/camera_text.h"
#include "renderer/options/data_file.h"
#include "renderer/picture/svg.h"
#include "ui/figure.h"
#include "ui/pixel_numbers.h"

namespace gbl {
namespace {

constexpr double kDotsPerCm = 300 / 2.54;

glm::ivec2 scaled(glm::ivec2 size, double scale) {
  return glm::max(glm::ivec2(glm::round(glm::dvec2(size) * scale)), glm::ivec2(1));
}

std::string place_of(const FigureSpec& f, const FigurePanel& p) {
  return fmt::format("{}: panel {}", f.id, &p - f.panels.data() + 1);
}

View view_of(const FigurePanel& p) { return view_by_id(p.view).view; }

ui::Zoom zoom_of(const Settings& s) { return ui::within({s.view.zoom, s.view.centre}, 1e9); }

// Rec. 709's luminance, on the display's codes: what a grey printer makes of them.
void make_grey(Image& image) {
  for (size_t i = 0; i < image.rgba.size(); i += 4) {
    const double grey = 0.2126 * image.rgba[i] + 0.7152 * image.rgba[i + 1] + 0.0722 * image.rgba[i + 2];
    std::fill_n(image.rgba.begin() + static_cast<std::ptrdiff_t>(i), 3, static_cast<uint8_t>(std::lround(grey)));
  }
}

// Of the pixels that are shown only: numbers of a whole frame would be millions of texts.
std::shared_ptr<const ui::PixelNumbers> shown_numbers(Lab& lab, View v, const ui::Zoom& zoom) {
  const glm::ivec2 size = lab.drawn().size;
  auto out = std::make_shared<ui::PixelNumbers>(ui::PixelNumbers{v, ui::shown_pixels(zoom, size), {}});
  const std::vector<glm::vec4> all = lab.numbers_of(v);
  for (int y = 0; y < out->pixels.count.y; ++y)
    for (int x = 0; x < out->pixels.count.x; ++x) {
      const glm::ivec2 at = out->pixels.first + glm::ivec2(x, y);
      out->values.push_back(all[static_cast<size_t>(at.y) * static_cast<size_t>(size.x) + static_cast<size_t>(at.x)]);
    }
  return out;
}

Settings other_side(Settings s, const FigureSpec& f, const FigurePanel& p) {
  apply_patch(s, p.against->set, place_of(f, p) + ": against");
  return s;
}

// The frame from a camera beside it: its planes hold the scene and the frame's own camera.
Canvas from_outside(Lab& lab, View v, const std::string& camera) {
  Settings s;
  apply_camera(s, camera, "outside");
  const Bounds& b = lab.scene().bounds;
  const double apart = glm::distance(s.camera.position, lab.drawn().camera.position),
               extent = glm::length(b.max - b.min);
  s.camera.near = std::max(1e-3, apart / 500), s.camera.far = 4 * (apart + extent);
  const gl::Texture depth =
      gl::make_texture({.size = lab.drawn().size, .format = Format::d32f, .label = "outside.depth"});
  Canvas picture = make_canvas({.size = lab.drawn().size, .linear_filter = true, .label = "outside"}, &depth);
  lab.draw_outside({s.camera, lab.drawn().size}, v, picture);
  return copied(picture);
}

}  // namespace

double scale_of(const FigureSpec& f, const FigureLook& look) {
  if (look.width_cm <= 0) return look.scale;
  ui::Sheet one;
  one.columns = f.columns, one.tile_width = static_cast<float>(f.size.x);
  for (const FigurePanel& p : f.panels)
    one.tiles.push_back({.view = view_of(p), .image = {0, f.size}, .drawn = {}, .legend = {}, .overlays = {}});
  return std::round(look.width_cm * kDotsPerCm) / ui::sheet_size(one).x;
}

double pixels_per_cm(const Image& image, const FigureLook& look) {
  return look.width_cm > 0 ? image.size.x / look.width_cm : 0;
}

Settings FigureMaker::settings_of_panel(const FigureSpec& f, const FigurePanel& p, double share) const {
  const std::string where = place_of(f, p);
  Settings s = settings_of(p.recipe, scaled(f.size, scale_of(f, look_)), where);
  if (f.frames) apply_patch(s, patch_at(*f.frames, share), where);
  s.view.main = p.view;
  return s;
}

void FigureMaker::require_drawable(const Settings& s, View v, const std::string& where) {
  look_up(where, [&] { require_valid(s, lab_.limits()); });
  if (const std::string missing = why_missing(v, s); !missing.empty())
    throw Error(ExitCode::bad_input, where, fmt::format("view '{}': {}", row(v).id, missing));
}

void FigureMaker::check(const FigureSpec& f) {
  if (!f.drawing.empty()) drawing_svg(f, {});
  if (f.window) require_drawable(settings_of(f.recipe, f.size, f.id), View::final, f.id);
  const int frames = f.frames ? f.frames->count : 1;
  for (const FigurePanel& p : f.panels)
    for (int k = 0; k < frames; ++k) {
      const Settings s = settings_of_panel(f, p, frames > 1 ? double(k) / (frames - 1) : 0);
      require_drawable(s, view_of(p), place_of(f, p));
      if (p.against) require_drawable(other_side(s, f, p), view_of(p), place_of(f, p) + ": against");
    }
}

void FigureMaker::draw_panel(SheetMaker& maker, const FigureSpec& f, const FigurePanel& p, double share) {
  const View v = view_of(p);
  const Settings s = settings_of_panel(f, p, share);
  const ui::Zoom zoom = zoom_of(s);
  const bool squares = zoom.scale > 1 || p.inset, overlaid = !needs_truth(v);
  std::optional<ui::SheetAgainst> against;
  if (p.against) {
    lab_.draw(other_side(s, f, p));
    draw_any_view(lab_, v, overlaid);
    against =
        ui::SheetAgainst{maker.keep(lab_.copy_of(v, squares)), p.against->from, p.against->left, p.against->right};
  }
  lab_.draw(s);
  if (!settings_) settings_ = s;
  draw_any_view(lab_, v, overlaid);
  ui::SheetTile& tile =
      p.outside.empty() ? maker.add(lab_, v, overlaid, squares) : maker.add(lab_, v, from_outside(lab_, v, p.outside));
  if (!p.outside.empty()) tile.name = "from outside";
  const bool lettered = f.letters && f.panels.size() > 1;
  tile.caption = lettered ? fmt::format("({}) {}", char('a' + (&p - f.panels.data()) % 26), p.words) : p.words;
  tile.zoom = zoom;
  tile.against = against;
  if (p.numbers) tile.numbers = shown_numbers(lab_, v, zoom);
  if (p.inset)
    tile.inset = ui::SheetInset{ui::within({p.inset->scale, p.inset->centre}, 1e9), p.inset->right, p.inset->top};
}

Image FigureMaker::picture(const FigureSpec& f, double share) {
  settings_.reset();
  if (f.window) {
    settings_ = settings_of(f.recipe, f.size, f.id);
    Image image = first_screen(lab_, *settings_, *f.window, false);
    if (look_.grey) make_grey(image);
    return image;
  }
  SheetMaker maker;
  for (const FigurePanel& p : f.panels) draw_panel(maker, f, p, share);
  ui::Sheet& sheet = maker.sheet();
  const double scale = scale_of(f, look_);
  sheet.columns = f.columns, sheet.scale = static_cast<float>(scale), sheet.light = look_.light;
  sheet.tile_width = static_cast<float>(scaled(f.size, scale).x);
  if (f.heading) sheet.title = f.title, sheet.caption = ui::made_in_words(*settings_, lab_.report());
  Image image = maker.picture();
  if (look_.grey) make_grey(image);
  return image;
}

void FigureMaker::write_numbers(const FigureSpec& f, const std::filesystem::path& path, const PngText& texts) {
  std::vector<std::pair<Settings, std::vector<View>>> frames;  // each drawn once
  for (const FigurePanel& p : f.panels) {
    Settings s = settings_of_panel(f, p, 0);
    s.view = {};
    const auto same = [&](const auto& frame) { return frame.first == s; };
    auto found = std::find_if(frames.begin(), frames.end(), same);
    if (found == frames.end()) found = frames.insert(frames.end(), {s, {}});
    if (const View v = view_of(p); std::find(found->second.begin(), found->second.end(), v) == found->second.end())
      found->second.push_back(v);
  }
  for (size_t i = 0; i < frames.size(); ++i) {
    lab_.draw(frames[i].first);
    const std::string name = i == 0 ? ".exr" : fmt::format("-{}.exr", char('a' + i % 26));
    write_layers(path.string() + name, lab_, frames[i].second, texts);
  }
}

std::string drawing_svg(const FigureSpec& f, const PngText& texts) {
  std::string svg = figure_drawing(f.drawing).svg(settings_of(f.recipe, f.size, f.id), f.title);
  std::string inside = fmt::format("<title>{}</title>\n", svg_escaped(f.title));
  for (const auto& [key, text] : texts)
    inside += fmt::format("<metadata id=\"{}\">{}</metadata>\n", key, svg_escaped(text));
  svg.insert(svg.find('\n') + 1, inside);
  return svg;
}

}  // namespace gbl
