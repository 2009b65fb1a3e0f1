#pragma once
// Settings that make no sense or that this device cannot draw: entries of a table, with ids that tests assert and
// sentences that window, command line and JSON all print.
#include <string>
#include <vector>

#include "renderer/options/settings.h"

namespace gbl {

enum class ProblemId {
  not_finite,
  size_above_limit,
  far_not_beyond_near,
  rig_not_read,
  rig_not_named,
  no_such_light,
  stencil_needs_d24,
  less_equal_needs_back,
  greater_equal_needs_front,
  feature_missing,
  alpha_not_stored,
  prepass_needs_split,
  antialias_needs_gbuffer,
  too_many_targets
};

struct Problem {
  ProblemId id;
  std::string path;      // of the option to change
  std::string sentence;  // what is wrong and how to fix it
};
const char* id_of(ProblemId);

struct DeviceLimits {
  FeatureSet features;
  int max_size = 16384;      // pixels a side
  int max_draw_buffers = 8;  // colour attachments of one pass
};

std::vector<Problem> validate(const Settings&, const DeviceLimits&);
void require_valid(const Settings&, const DeviceLimits&);  // Error(bad_input) with the first problem

// Settings from another machine, as near as this one comes: values whose feature it lacks give way to those before them.
struct Nearest {
  Settings settings;
  std::vector<std::string> sentences;  // of each that gave way
};
Nearest nearest_with(const FeatureSet&, Settings);

}  // namespace gbl
