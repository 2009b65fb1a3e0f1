#pragma once
// The bits of a pixel, field by field: where each lies, its code, and the number that is read from it.
#include <string>
#include <vector>

#include "renderer/frame/stored_fields.h"
#include "renderer/inspect/pixel_probe.h"

namespace gbl {

struct FieldRead {
  StoredField field;
  std::string place;                // "r28-31|g26-31"
  std::vector<std::string> binary;  // of each component, the highest bit first; empty where nobody can read them
  std::vector<uint32_t> codes;
  std::vector<double> values;  // as the lighting takes them; a normal's are its direction in the world
};

// settings: those that the frame was drawn with, resolved.
std::vector<FieldRead> read_fields(const Settings&, const StoredTexel&);

}  // namespace gbl
