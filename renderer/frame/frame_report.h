#pragma once
// What a frame cost: handed from renderer to UI, command line and studies. Unknown is empty, never zero.
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "renderer/options/settings.h"

namespace gbl {

struct PassTime {
  std::string pass;          // "geometry", "lighting", "combine", "display", "count", …
  std::optional<double> ms;  // empty until the query has answered
};

// Bytes of a pixel that a pass reads from targets and writes into them, at most, if it does so once. Methods that blend
// read and write for each pair.
struct PassTraffic {
  std::string pass;
  int read = 0, written = 0;
};

struct PairCounts {
  uint64_t tested = 0;          // (pixel with geometry, light) whose record was read for that pixel
  uint64_t shaded = 0;          // of those, passed to shade()
  std::optional<uint64_t> lit;  // distance < range; counted by a pass of its own
};

// How the clustered method cut the picture, and what it listed.
struct ListReport {
  int tile_px = 0;      // a tile's side
  double light_px = 0;  // a light's width, the mean of those in view
  uint64_t entries = 0;
  int everywhere = 0;   // lights that every pixel reads
  bool looked = false;  // was it found out where surfaces are?
  double ms = 0;  // of the CPU, when they were last made: they are kept while nothing moves; without waiting for depths
};

struct FrameReport {
  glm::ivec2 size{0};                // as drawn
  std::vector<PassTime> passes;      // in the order drawn
  std::vector<PassTraffic> traffic;  // of those passes that have any
  double upload_ms = 0;              // of the CPU, for the frame's constants and lights
  std::string time_source;           // "gpu-query", "software-rasteriser" or "cpu-clock"
  std::optional<PairCounts> pairs;
  std::optional<ListReport> lists;
  int draw_calls = 0;
  int gbuffer_bytes_per_pixel = 0;
  int accumulation_bytes_per_pixel = 0;
  double mib = 0;                    // of all targets of the frame
  int light_count = 0;               // lights drawn
  int light_total = 0;               // those there are: lights.only draws one of them
  Settings drawn;                    // the settings with nothing left to choose (renderer/frame/resolve.h)
  std::vector<std::string> choices;  // what was chosen for `auto` and why
  std::string method_reason;         // why lights.method=auto chose `drawn`'s; empty if it was asked for by name
  std::string note;                  // reduced size, missing feature, …; empty = nothing to say
};

}  // namespace gbl
