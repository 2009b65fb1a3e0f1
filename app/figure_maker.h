#pragma once
// From a figure's spec to its picture.
#include <optional>
#include <string>

#include "app/lab.h"
#include "renderer/figures/figure_spec.h"

namespace gbl {

// How a figure is made, whatever is in it.
struct FigureLook {
  double scale = 1;     // of frames, type and lines
  double width_cm = 0;  // as printed at 300 dots per inch: then the scale follows; 0: not asked for
  bool light = false;   // on white paper
  bool grey = false;    // as a printer without colours shows it
};

double scale_of(const FigureSpec&, const FigureLook&);
double pixels_per_cm(const Image&, const FigureLook&);  // 0: not said

class FigureMaker {
 public:
  FigureMaker(Lab& lab, const FigureLook& look) : lab_(lab), look_(look) {}

  // Error(bad_input) if a picture's settings are not valid here or do not store its view, or a drawing cannot be made. Renders
  // nothing.
  void check(const FigureSpec&);

  // share: 0..1 along its keys, of a figure that has frames.
  Image picture(const FigureSpec&, double share = 0);
  // Of the picture drawn last: its first panel's settings, as asked for.
  const Settings& settings() const { return *settings_; }
  // The numbers of a figure's panels as EXR files, one for each frame that is drawn: FILE, FILE-b, FILE-c, …
  void write_numbers(const FigureSpec&, const std::filesystem::path& without_ending, const PngText&);

 private:
  void require_drawable(const Settings&, View, const std::string& where);
  Settings settings_of_panel(const FigureSpec&, const FigurePanel&, double share) const;
  void draw_panel(class SheetMaker&, const FigureSpec&, const FigurePanel&, double share);

  Lab& lab_;
  FigureLook look_;
  std::optional<Settings> settings_;
};

// A drawing's SVG, with what makes it again inside.
std::string drawing_svg(const FigureSpec&, const PngText&);

}  // namespace gbl
