#pragma once
// What the pitfalls' panel remembers, and its two pages: the list, and the entry that is open.
#include "ui/panels/side_panel.h"

namespace gbl::ui {

enum class Shown { broken, fixed, reference, difference, hidden };

struct OpenPitfall {
  PitfallEntry entry;
  Shown shown = Shown::broken;
  bool revealed = false;
  std::optional<double> along;  // where the camera is on the path; empty: nowhere on it
};

struct PitfallsState : PanelState {
  std::vector<PitfallEntry> entries;
  size_t chosen = 0;
  char find[64] = {};
  std::optional<OpenPitfall> opened;
  struct Before {
    Settings settings;
    bool large;
    Comparison comparison;
  };
  std::optional<Before> before;  // the first entry was opened
  double last_seconds = 0;
};

std::vector<size_t> found_entries(const PitfallsState&);  // by what is typed into its search

// The one that is clicked.
std::optional<size_t> draw_pitfall_list(const FrameContext&, const PitfallsState&, Painter&, const Box&);
void draw_pitfall_entry(const FrameContext&, const OpenPitfall&, Painter&, const Box&);
// The number along its path, broken and fixed, and where the camera is.
void draw_pitfall_path(const FrameContext&, const OpenPitfall&, Painter&, const Box&);

}  // namespace gbl::ui
