#pragma once
// A frame's report as JSON, in the columns that studies use.
#include "app/lab.h"
#include "renderer/base/json_fwd.h"

namespace gbl {

Json report_json(const Lab&);

}  // namespace gbl
