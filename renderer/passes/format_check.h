#pragma once
// Does this GPU store and read back what its tables say? Known values through a normal encoding, a depth format or an
// accumulation format: a driver that rounds, clamps or decodes otherwise makes every number of the lab doubtful, and no
// picture shows it.
#include <string>
#include <variant>
#include <vector>

#include "renderer/gbuffer/gbuffer_axes.h"
#include "renderer/gbuffer/normal_encoding.h"
#include "renderer/gl/device.h"
#include "renderer/options/settings.h"

namespace gbl {

// What is checked: a row of normal.encoding, depth.format (never auto) or accumulation.format.
using StoredAs = std::variant<NormalEncoding, DepthFormat, AccumulationFormat>;
std::string name_of(StoredAs);  // "normal.encoding=oct16"

std::vector<StoredAs> stored_by(const Settings& resolved);  // by a frame; nothing may be `auto`
std::vector<StoredAs> all_stored(FeatureSet);               // that a device with these features can be asked for

struct FormatCheck {
  StoredAs checked;
  double error;      // the largest of all values; not a number where nothing finite came back
  double bound;      // what the format's table allows, in the same unit
  const char* unit;  // "degrees" of normals; "steps" of the format at that value, else

  bool holds() const { return error <= bound; }
  std::string said() const;  // one clause
};

// Needs a current context and waits for the GPU: some tens of milliseconds, most of them compiling.
FormatCheck check_format(StoredAs, const gl::RoundingProbe&);

}  // namespace gbl
