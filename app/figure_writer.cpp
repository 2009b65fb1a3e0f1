#include "app/figure_writer.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/picture_texts.h"
#include "renderer/base/external_program.h"
#include "renderer/base/files.h"
#include "renderer/base/json.h"
#include "renderer/base/made_by.h"
#include "renderer/options/settings_json.h"
#include "renderer/picture/palette.h"
#include "renderer/picture/picture_difference.h"

namespace gbl {
namespace {

namespace fs = std::filesystem;

// Codes of 255, in the mean over squares of so many pixels: what has moved or changed its colour is further off, what another driver
// rounds otherwise is not.
constexpr double kSameWithin = 6;
constexpr int kSquare = 16;

std::string frame_name(const FigureSpec& f, int k) { return fmt::format("{}/{:04}.png", f.id, k + 1); }

FigureWords words_of(const FigureSpec& f, const std::string& file, const std::string& made, const FigureOptions& o) {
  const std::string panels = panel_words(f);
  return {.id = f.id,
          .file = file,
          .on_paper = file.ends_with(".gif") ? frame_name(f, 0) : "",
          .title = f.title,
          .caption = panels.empty() ? f.caption : f.caption + " " + panels,
          .alt = alt_text(f),
          .source = f.source,
          .command = figure_command(f, o),
          .made_by = made,
          .width_cm = o.look.width_cm};
}

void write_picture(const fs::path& path, const Image& image, const PngText& texts, const FigureOptions& o) {
  const double density = pixels_per_cm(image, o.look);
  o.few_colours ? write_indexed_png(path, image, texts, density) : write_png(path, image, texts, density);
}

PngText texts_of(const FigureSpec& f, const Settings& s, const Machine& machine, const FigureOptions& o) {
  PngText texts = picture_texts("gbufferlab render", s, machine);
  texts.back().second = figure_command(f, o);
  texts.push_back({kFigureKey, f.json + "\n"});
  texts.push_back({"Title", f.title});
  texts.push_back({"Description", alt_text(f)});
  return texts;
}

double share_of(const FigureSpec& f, int k) { return double(k) / (f.frames->count - 1); }

// Of a longer film before.
void remove_frames_after(const fs::path& folder, const FigureSpec& f) {
  for (int k = f.frames->count; fs::exists(folder / frame_name(f, k)); ++k) fs::remove(folder / frame_name(f, k));
}

// Joined beside the frames and then moved: nobody ever sees half of it. False: ImageMagick is not installed.
bool join_frames(std::vector<std::string> arguments, const fs::path& frames, const fs::path& film) {
  const fs::path joined = frames / "joined.gif";
  arguments.push_back(joined.string());
  std::error_code ignored;
  try {
    if (!run_program_if_there("convert", std::move(arguments))) return false;
    fs::rename(joined, film);
  } catch (...) {
    fs::remove(joined, ignored);
    throw;
  }
  return true;
}

// Numbered pictures; returns the file that a document shows. Ends early when it is interrupted.
std::string write_frames(const fs::path& folder, const FigureSpec& f, FigureMaker& maker, const Machine& machine,
                         const FigureOptions& o) {
  make_folder(folder / f.id);
  remove_frames_after(folder, f);
  std::vector<std::string> arguments{"-delay", fmt::format("{:.0f}", 100 / f.frames->per_second), "-loop", "0"};
  for (int k = 0; k < f.frames->count; ++k) {
    if (o.interrupted && *o.interrupted) return frame_name(f, 0);
    const Image image = maker.picture(f, share_of(f, k));
    const fs::path path = folder / frame_name(f, k);
    write_picture(path, image, texts_of(f, maker.settings(), machine, o), o);
    arguments.push_back(path.string());
  }
  if (join_frames(std::move(arguments), folder / f.id, folder / (f.id + ".gif"))) return f.id + ".gif";
  fmt::print(stderr, "gbufferlab: {}: ImageMagick is not installed, so the frames were not joined to a GIF\n", f.id);
  return frame_name(f, 0);
}

// Of the part that is drawn: what stands before it says what made it.
std::string drawn_part(const std::string& svg) { return svg.substr(std::min(svg.find("<rect"), svg.size())); }

std::string why_off(const fs::path& path, const FigureSpec& f, FigureMaker& maker, double share) {
  if (!fs::exists(path)) return "is missing";
  const Image old = read_png(path), now = maker.picture(f, share);
  if (old.size != now.size)
    return fmt::format("is {} x {}, and now it would be {} x {}", old.size.x, old.size.y, now.size.x, now.size.y);
  const double off = std::min(largest_square_difference(old, now, kSquare),
                              largest_square_difference(old, expanded(indexed(now)), kSquare));  // either may be kept
  return off <= kSameWithin ? "" : fmt::format("is off by {:.0f} codes of 255 somewhere", off);
}

// Of figures that were made before and are not made again, what stands there stays.
Json captions_before(const fs::path& file, const std::vector<FigureWords>& now) {
  Json kept = Json::array();
  if (!fs::exists(file)) return kept;
  const Json before = read_json(file);
  if (!before.is_object() || !before.contains("figures"))
    throw Error(ExitCode::bad_input, file.string(), "holds no captions", "move it away: it would be written over");
  const auto again = [&](const Json& f) {
    return std::any_of(now.begin(), now.end(),
                       [&](const FigureWords& w) { return f.contains("id") && f["id"] == w.id; });
  };
  for (const Json& f : before["figures"])
    if (f.is_object() && !again(f)) kept.push_back(f);
  return kept;
}

}  // namespace

void write_words(const fs::path& folder, const FigureWords& words) {
  write_text_file(folder / (words.id + ".md"), markdown_caption(words));
  write_text_file(folder / (words.id + ".tex"), latex_caption(words));
}

std::string figure_command(const FigureSpec& f, const FigureOptions& o) {
  std::string line = fmt::format("gbufferlab figures {} --only {}", shell_quoted(o.set), f.id);
  if (!f.drawing.empty()) return line;
  if (o.look.width_cm > 0) line += fmt::format(" --width-cm {:g}", o.look.width_cm);
  if (o.look.scale != 1) line += fmt::format(" --scale {:g}", o.look.scale);
  if (o.look.light) line += " --light";
  if (o.look.grey) line += " --grey";
  if (!o.without.empty()) line += fmt::format(" --without {}", o.without);
  return line;
}

std::optional<FigureWords> write_figure(const fs::path& folder, const FigureSpec& f, FigureMaker& maker,
                                        const Machine& machine, const FigureOptions& o) {
  const std::string made = fmt::format("{} on {}", made_by(), machine.device);
  std::string file = f.id + (f.drawing.empty() ? ".png" : ".svg");
  if (!f.drawing.empty()) {
    const PngText texts = {{kFigureKey, f.json}, {kCommandKey, figure_command(f, o)}, {kVersionKey, made_by()}};
    write_text_file(folder / file, drawing_svg(f, texts));
  } else if (f.frames) {
    file = write_frames(folder, f, maker, machine, o);
    if (o.interrupted && *o.interrupted) return {};
  } else {
    const Image image = maker.picture(f);
    write_picture(folder / file, image, texts_of(f, maker.settings(), machine, o), o);
  }
  if (o.numbers && !f.panels.empty()) maker.write_numbers(f, folder / f.id, texts_of(f, maker.settings(), machine, o));
  FigureWords words = words_of(f, file, made, o);
  if (!o.pictures_only) write_words(folder, words);
  return words;
}

void write_captions(const fs::path& folder, const std::string& title, const std::vector<FigureWords>& all) {
  const fs::path file = folder / "captions.json";
  Json figures = captions_before(file, all);
  for (const FigureWords& w : all) figures.push_back(caption_json(w));
  write_text_file(file, Json{{"version", 1}, {"title", title}, {"figures", figures}}.dump(2) + "\n");
}

std::string why_outdated(const fs::path& folder, const FigureSpec& f, FigureMaker& maker) {
  const auto named = [](const std::string& file, const std::string& why) {
    return why.empty() ? why : file + " " + why;
  };
  if (!f.drawing.empty()) {
    const std::string file = f.id + ".svg";
    if (!fs::exists(folder / file)) return named(file, "is missing");
    const bool same = drawn_part(read_text_file(folder / file)) == drawn_part(drawing_svg(f, {}));
    return same ? "" : named(file, "is drawn otherwise now");
  }
  if (!f.frames) return named(f.id + ".png", why_off(folder / (f.id + ".png"), f, maker, 0));
  for (const int k : {0, f.frames->count - 1})  // the film's ends
    if (const std::string why = why_off(folder / frame_name(f, k), f, maker, share_of(f, k)); !why.empty())
      return named(frame_name(f, k), why);
  return "";
}

}  // namespace gbl
